#: description = "The pedestrian runs into the road, then turns back to where it came from."
#: adversaries = ["pedestrian"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "turn-back"]

param OPT_ADV_SPEED = Range(1.5, 5)  #: [m/s] how fast it goes
param OPT_ADV_DISTANCE = Range(20, 40)  #: [m] how far the ego still has to go when it starts to move
param OPT_ADV_REACH = Range(0, 1)  #: [m] how far from the ego's line it turns back

behavior AdvBehavior():
    # Earlier where it has farther to go, and briskly where the ego would be gone otherwise.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(5) until abs(offsetFrom(egoRoute, self)) < max(2.5, globalParameters.OPT_ADV_SPEED * headway(egoRoute, ego, self) / 8)
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_ADV_REACH)
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 3.14159)
