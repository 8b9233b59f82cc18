#: description = "The car noses half into the ego's lane and stops there, straddling the line."
#: rephrasings = [
#:   "Somebody pokes his nose halfway into our lane and then stops, hogging both.",
#:   "Vehicle 2 straddled the lane line and came to rest partly in the path of vehicle 1.",
#:   "Partial cut-in, stops on the marking.",
#:   "The target performs an incomplete lane change and comes to standstill overlapping the VUT's path.",
#:   "The car is half in our lane, half in his, and it stands.",
#:   "A taxi wants over, chickens out midway and halts astride the dashes.",
#:   "The ambulance leaves its rear in the next lane and its front in ours, at rest.",
#:   "A van edges over the marking, sees no room and freezes there.",
#:   "the taxi next to me poked his snout over the line and just parked it there, half in his lane and half in mine",
#:   "V2 in the adjacent lane encroached partway into V1's lane and came to rest straddling the lane line.",
#:   "Car alongside: edges over, halts astride marking, blocks half our lane.",
#:   "Adjacent target makes a partial lane change of 50 % overlap and remains stationary on the lane marking.",
#:   "The police car from other lane comes only half to my lane and then stays standing on the line.",
#:   "Neighbouring actor aborts lane change midway and parks on the divider stripe, half of our width taken.",
#:   "The saloon leaned over into her lane, got as far as its door mirrors, and there it froze with two wheels on either side of the paint.",
#:   "He wants your lane but he's only gone half the job: nose in, tail out, and now he's sat there across the dashes.",
#:   "dude started coming into our lane then just gave up halfway and parked there wtf",
#:   "Queues formed after a saloon abandoned its manoeuvre with half its bodywork poking into the neighbouring stream",
#:   "And there he remained, half in one lane and half in the other, the nose obstructing my client?",
#:   "Cab beside us come in half body only then stop, neither here nor there, very irritating leh",
#:   "He sticks his bonnet in my lane and leaves it there like a foot in the door, won't come in, won't go out",
#:   "Incomplete lateral intrusion from adjacent lane with stationary overhang",
#:   "Police car gets STUCK between two lanes right beside me",
#:   "The estate car wedged its snout into our lane and froze.",
#: ]
#: adversaries = ["car", "emergency-vehicle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["swerve", "stop"]
#: leader = false
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 12.0
#: high = 18.0
#: unit = "m"
#: meaning = "how far ahead of the ego it stays"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.25
#: high = 1.7
#: unit = "m"
#: meaning = "how far it noses over"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.4
#: high = 0.8
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_DISTANCE = Range(0, 30)
param OPT_ADV_AHEAD = Range(12, 18)
param OPT_SWERVE = Range(1.25, 1.7)
param OPT_BRAKE = Range(0.4, 0.8)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and headway(egoRoute, ego, self) > 8
    do SwerveOnPath(advLane, 6, -globalParameters.OPT_SWERVE if offsetFrom(egoRoute, self) > 0 else globalParameters.OPT_SWERVE) for 0.8 seconds
    do BrakeOnPath(advLane, globalParameters.OPT_BRAKE, -globalParameters.OPT_SWERVE if offsetFrom(egoRoute, self) > 0 else globalParameters.OPT_SWERVE)
