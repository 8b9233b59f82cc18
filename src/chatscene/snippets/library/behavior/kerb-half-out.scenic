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
#:   "Ambulance at the kerb comes out to its front doors and stays there.",
#:   "Bonnet in our lane, boot in the bay, and not moving.",
#:   "The parked cab edges halfway into the road and halts.",
#:   "Make the parked lorry emerge by half its width, then freeze.",
#:   "Just the front end leaves the bay, and there it rests, obstructing us.",
#:   "From the row of parked vehicles a removal van angles out until its cab is in front of us, and it goes no farther than that.",
#:   "The obstacle is created by a parked car which steers partly out of its space and remains stationary with its front overhanging the lane of the VUT.",
#:   "I couldn't get by because a minibus that had been parked on the left had stuck its front wheels out in my lane and was now just standing.",
#:   "Stop, stop: the blue one by the kerb wants out, he's come half the way, and now he's planted there with his wing across your lane.",
#:   "Please set up a parked police car that drives out of its space at an angle and brakes to rest while its rear is still at the kerb.",
#:   "El coche was parked, he goes out the half of him, the nose is in my lane and the tail not, and there he remains quiet.",
#:   "When I first saw the Transit it was parked tight to the kerb like all the others. Then its wheels turned and it slid out maybe a metre and a half, and that was that. It neither finished coming out nor went back, so its nose was sitting in my lane.",
#:   "The bus was standing in the lay-by. Its operator pulled the front axle over the edge line and came to a stop, leaving the rear section in the lay-by and the front left corner about four feet inside the travel lane of Vehicle 1.",
#:   "At forty-four tonnes you don't thread needles. This parked hatchback came creeping out with its front half, blocked the best part of my lane and then sat tight, the driver looking the other way over her shoulder, and her rear wheels never left the space.",
#:   "It was as if the old saloon had wanted to sniff the street. It put out its head from between two neighbours, as far as the windscreen, and with that in the way of everyone who came along the lane, it stopped and came out no more.",
#:   "How does the AV handle a car that's only part-way out? That's the question here: the actor begins parked, pokes into our lane with about half its body, brakes to zero at that angle and does not complete the departure.",
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
