#: description = "The car cuts across in front of the ego at the last moment and leaves the road to the right."
#: adversaries = ["car", "motorcycle", "truck", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["cut-in", "turn-right"]
#: side = "left"
#: maneuver = "straight"
#: place = "road"
#: leader = false

param OPT_ADV_DISTANCE = Range(0, 25)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_AHEAD = Range(4, 11)  #: [m] how far ahead of the ego it stays
param OPT_ADV_SPEED = Range(5, 6.5)  #: [m/s] how fast it turns off

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and headway(leftLane, ego, self) > 2
    do TurnOff(-0.9, globalParameters.OPT_ADV_SPEED, 9)
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for 3 seconds
    do Halt()
