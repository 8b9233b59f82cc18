#: description = "The cyclist crosses and brakes suddenly in the middle of the intersection, obstructing the ego."
#: adversaries = ["bicycle", "motorcycle"]
#: origin = "base scenario turning-obstacle; own code"
#: [slots]
#: actions = ["cross", "brake", "stop"]

param OPT_ADV_SPEED = Range(3, 6)  #: [m/s] how fast it rides
param OPT_ADV_DISTANCE = Range(12, 30)  #: [m] how far the ego still has to go when it starts
param OPT_STOP_DISTANCE = Range(0, 1)  #: [m] how far from the ego's line it comes to rest

behavior AdvBehavior():
    # Earlier where it has farther to go, or on a wide road it would pass behind the ego.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED + 2 * globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt()
