#: description = "The rider pulls out from the roadside into the ego's lane and rides along it against the traffic, toward the ego."
#: adversaries = ["bicycle", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "wrong-way"]
#: side = "right"
#: maneuver = "straight"
#: place = "road"

param OPT_ADV_SPEED = Range(2.5, 5.5)  #: [m/s] how fast it rides
param OPT_ADV_DISTANCE = Range(32, 52)  #: [m] how far the ego still has to go when it starts to move
param OPT_ADV_REACH = Range(0.7, 1.5)  #: [m] how far from the ego's line it rides

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    do MoveAhead(5) until abs(offsetFrom(egoRoute, self)) < 2.2
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_REACH if offsetFrom(egoRoute, self) < 0 else -globalParameters.OPT_ADV_REACH)
