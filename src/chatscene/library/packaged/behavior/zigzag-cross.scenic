#: description = "The pedestrian staggers across the road in a zigzag."
#: adversaries = ["pedestrian"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "weave"]

param OPT_ADV_SPEED = Range(1.5, 4)  #: [m/s] how fast it goes
param OPT_ADV_DISTANCE = Range(14, 42)  #: [m] how far the ego still has to go when it starts to move
param OPT_ADV_ANGLE = Range(0.6, 1)  #: [rad] how far each leg slants

behavior AdvBehavior():
    # Earlier where it has farther to go, and briskly where the ego would be gone otherwise.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(5) until abs(offsetFrom(egoRoute, self)) < max(2.5, globalParameters.OPT_ADV_SPEED * headway(egoRoute, ego, self) / 12)
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE) for 0.6 seconds
    while True:
        do MoveAhead(globalParameters.OPT_ADV_SPEED, -2 * globalParameters.OPT_ADV_ANGLE) for 1.2 seconds
        do MoveAhead(globalParameters.OPT_ADV_SPEED, 2 * globalParameters.OPT_ADV_ANGLE) for 1.2 seconds
