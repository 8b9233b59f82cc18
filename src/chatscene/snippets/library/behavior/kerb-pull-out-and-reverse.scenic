#: description = "The parked car pulls out, stops and backs up toward the ego."
#: rephrasings = [
#:   "He pulls out, stops, and then comes back at us in reverse.",
#:   "Vehicle 2 left the curb, stopped in the lane and backed up.",
#:   "Parked veh out, stop, reversing in lane.",
#:   "The target merges ahead of the VUT, stands and then moves rearward.",
#:   "It comes out of parking, stands before us and goes backward.",
#:   "A removal lorry leaves the side, halts and backs to line up with a door.",
#:   "The taxi sets off, sees a hand go up and shunts back.",
#:   "Out of his space, the driver notes he forgot his wife and reverses.",
#:   "This parked van came out, halted, then started backing at me, beep beep beep.",
#:   "Unit 2 left its parked position, came to a stop in the travel lane, then backed toward Unit 1.",
#:   "Truck out of bay, halt, then R gear towards us.",
#:   "The parked target enters the lane, comes to rest and then moves rearward in the direction of the test vehicle.",
#:   "Car goes out from parking, stands, and comes backwards to me.",
#:   "Parked actor: leaves the edge, stops in our lane, then negative speed into our approach.",
#:   "It had come out from the roadside and paused, and then its white lamps lit and it rolled backwards at them.",
#:   "Bus is moving off from the side, he's stopped, watch it, he's in reverse and he's coming at you.",
#:   "parked truck pulls out, stops, then starts coming at me BACKWARDS",
#:   "A delivery van moved off from the roadside, halted and then rolled rearwards at an approaching driver.",
#:   "Having come out from the side and stood, your vehicle then travelled tail foremost upon my client, correct?",
#:   "The parked lorry come out, stop, then gostan towards my car, siao or what.",
#:   "Comes off the side, has a sit, and then he's backing down on me with his rear end getting bigger and bigger.",
#:   "Departure of parked vehicle into own lane, halt and subsequent rearward approach",
#:   "PULLS OUT, STOPS, THEN REVERSES AT ME",
#:   "The parked bus emerges, halts and backs down upon us.",
#: ]
#: adversaries = ["car", "truck", "bus", "emergency-vehicle"]
#: requires = ["advKerb", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "stop", "reverse"]
#: position = "kerb"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 16.0
#: high = 34.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.4
#: high = 0.9
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_ADV_BACK_SPEED"
#: low = 0.8
#: high = 2.4
#: unit = "m/s"
#: meaning = "how fast it backs up"

param OPT_ADV_DISTANCE = Range(16, 34)
param OPT_BRAKE = Range(0.4, 0.9)
param OPT_ADV_BACK_SPEED = Range(0.8, 2.4)

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3) for 0.3 seconds
    do DrivePath(ownLane(egoRoute), 4.5) until abs(offsetFrom(ownLane(egoRoute), self)) < 1
    do BrakeOnPath(ownLane(egoRoute), globalParameters.OPT_BRAKE) until self.pose[3] < 0.05
    do Halt() for 0.6 seconds
    do ReverseStraight(globalParameters.OPT_ADV_BACK_SPEED) for 4 seconds
    do Halt()
