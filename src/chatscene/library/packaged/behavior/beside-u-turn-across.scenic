#: description = "The car makes a U-turn from the lane beside, right across the ego's lane."
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "u-turn"]
#: side = "right"
#: maneuver = "straight"
#: place = "road"
#: leader = false

param OPT_ADV_DISTANCE = Range(12, 35)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_AHEAD = Range(7, 14)  #: [m] how far ahead of the ego it stays
param OPT_ADV_SPEED = Range(3.8, 4.6)  #: [m/s] how fast it turns round
param OPT_TURN_RADIUS = Range(6, 7)  #: [m] the radius of its turn

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and headway(rightLane, ego, self) > 5
    do TurnOff(3.1, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_TURN_RADIUS)
    do MoveAhead(6)
