#: description = "The car turns left from the lane beside and crosses right in front of the ego."
#: adversaries = ["car", "motorcycle", "truck", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "turn-left"]
#: side = "right"
#: maneuver = "straight"
#: place = "road"
#: leader = false

param OPT_ADV_DISTANCE = Range(0, 25)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_AHEAD = Range(7, 14)  #: [m] how far ahead of the ego it stays
param OPT_ADV_SPEED = Range(4, 5)  #: [m/s] how fast it turns

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and headway(rightLane, ego, self) > 5
    do TurnOff(1.2, globalParameters.OPT_ADV_SPEED, 7)
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for 4 seconds
    do Halt()
