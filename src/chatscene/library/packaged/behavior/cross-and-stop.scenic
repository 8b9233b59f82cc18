#: description = "The pedestrian suddenly crosses the road and stops in front of the ego."
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "stop"]

param OPT_ADV_SPEED = Range(1.4, 5)  #: [m/s] how fast it goes
param OPT_ADV_DISTANCE = Range(10, 40)  #: [m] how far the ego still has to go when the adversary starts to move
param OPT_STOP_DISTANCE = Range(0, 1)  #: [m] how far from the ego's line it comes to rest

behavior AdvBehavior():
    # Earlier where it has farther to go, and briskly where the ego would be gone otherwise.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(5) until abs(offsetFrom(egoRoute, self)) < max(2.5, globalParameters.OPT_ADV_SPEED * headway(egoRoute, ego, self) / 8)
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt()
