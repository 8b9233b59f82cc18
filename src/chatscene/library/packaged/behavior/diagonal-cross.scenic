#: description = "The pedestrian crosses the road diagonally, slanting along it."
#: adversaries = ["pedestrian", "bicycle"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "diagonal"]

param OPT_ADV_SPEED = Range(1.3, 4.5)  #: [m/s] how fast it goes
param OPT_ADV_DISTANCE = Range(18, 52)  #: [m] how far the ego still has to go when it starts to move
param OPT_ADV_ANGLE = Range(0.55, 0.9)  #: [rad] how far its way turns from straight across

behavior AdvBehavior():
    # Earlier where it has farther to go, and briskly where the ego would be gone otherwise.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(5) until abs(offsetFrom(egoRoute, self)) < max(2.5, globalParameters.OPT_ADV_SPEED * headway(egoRoute, ego, self) / 12)
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE if offsetFrom(egoRoute, self) > 0 else -globalParameters.OPT_ADV_ANGLE)
