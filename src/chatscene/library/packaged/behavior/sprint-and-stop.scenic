#: description = "The pedestrian suddenly sprints out onto the road in front of the ego and stops."
#: adversaries = ["pedestrian"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "accelerate", "stop"]

param OPT_ADV_SPEED = Range(4, 7)  #: [m/s] how fast it runs
param OPT_ADV_DISTANCE = Range(10, 22)  #: [m] how far the ego still has to go when it starts to run
param OPT_STOP_DISTANCE = Range(0, 1)  #: [m] how far from the ego's line it comes to rest

behavior AdvBehavior():
    # Earlier where it has farther to go, or on a wide road it would pass behind the ego.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt()
