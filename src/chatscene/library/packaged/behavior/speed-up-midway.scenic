#: description = "The pedestrian starts across slowly and suddenly breaks into a run."
#: adversaries = ["pedestrian", "bicycle"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "accelerate"]

param OPT_ADV_SPEED = Range(0.8, 2)  #: [m/s] how fast it starts
param OPT_ADV_SPRINT = Range(4.5, 7)  #: [m/s] how fast it runs in the end
param OPT_ADV_DISTANCE = Range(24, 56)  #: [m] how far the ego still has to go when it starts to move
param OPT_ADV_REACH = Range(1, 3)  #: [m] how far from the ego's line it breaks into a run

behavior AdvBehavior():
    # Earlier where it has farther to go, and briskly where the ego would be gone otherwise.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(5) until abs(offsetFrom(egoRoute, self)) < max(2.5, globalParameters.OPT_ADV_SPEED * headway(egoRoute, ego, self) / 8)
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    do MoveAhead(globalParameters.OPT_ADV_SPRINT)
