#: description = "The parked car noses halfway out of its space and stops with its front in the ego's lane."
#: rephrasings = [
#:   "The parked car sticks its snout out and stops, half in our lane.",
#:   "Vehicle 2 protruded partially into the travel lane from a parking space and stopped.",
#:   "Parked veh half out, stationary.",
#:   "The target leaves the parking strip partially and comes to standstill overlapping the VUT's lane.",
#:   "It comes out only the half and stands, we have not enough place.",
#:   "A van pokes out to see past the others and stays there.",
#:   "The bus swings its front out, gets no gap and waits jutting into the road.",
#:   "A lorry angles off the roadside, thinks better of it and leaves its corner out.",
#:   "This parked van stuck its nose out into my lane and just sat there, half in and half out.",
#:   "The legally parked vehicle advanced partially from its space and came to rest with its front end obstructing the travel lane.",
#:   "Parked car noses out ~half, stops; front in ego lane, tail still in bay.",
#:   "The parked target moves partly out of its bay and halts, its front section protruding into the VUT's lane.",
#:   "A parked car comes out only with the front and stays so, half in my lane.",
#:   "Parked actor pokes out to ~50% and freezes; partial-width obstacle that never completes the pull-out.",
#:   "He edged its snout out from the row and then, having spoiled half her lane, he stayed put.",
#:   "He's stuck his bonnet out of that space and stopped, so you'll have to get round his front end.",
#:   "parked car poked its face out into my lane and then just.. stayed like that",
#:   "A delivery lorry stood with its bonnet jutting into traffic after leaving its bay only in part.",
#:   "Your vehicle was neither parked nor driving; its forward half stood in my client's lane, motionless?",
#:   "Parked van came out half only, half body inside, half body on the road, and stopped there.",
#:   "He pokes his snout out of the parking spot and leaves it hanging in my lane, neither use nor ornament.",
#:   "Partial protrusion of formerly parked vehicle into ego lane, stationary.",
#:   "PARKED CAR STICKS NOSE OUT AND JUST STOPS THERE",
#:   "A parked bus jutted its snout into our lane and froze.",
#: ]
#: adversaries = ["car", "truck", "bus", "emergency-vehicle"]
#: requires = ["advKerb", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["stop"]
#: side = "right"
#: position = "kerb"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 16.0
#: high = 34.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 0.8
#: high = 1.35
#: unit = "m"
#: meaning = "how far it noses out"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.3
#: high = 0.8
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_DISTANCE = Range(16, 34)
param OPT_SWERVE = Range(0.8, 1.35)
param OPT_BRAKE = Range(0.3, 0.8)

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3, (-globalParameters.OPT_SWERVE if offsetFrom(ownLane(egoRoute), self) > 0 else globalParameters.OPT_SWERVE)) until abs(offsetFrom(advKerb, self)) > 0.7 * globalParameters.OPT_SWERVE
    do BrakeOnPath(advKerb, globalParameters.OPT_BRAKE, (-globalParameters.OPT_SWERVE if offsetFrom(ownLane(egoRoute), self) > 0 else globalParameters.OPT_SWERVE))
