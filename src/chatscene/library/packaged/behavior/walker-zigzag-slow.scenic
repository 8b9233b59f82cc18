#: description = "The pedestrian reels across the road slowly, swaying from side to side."
#: adversaries = ["pedestrian"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "weave", "slow"]

param OPT_ADV_SPEED = Range(0.95, 1.35)  #: [m/s] how fast it goes
param OPT_ADV_DISTANCE = Range(6, 34)  #: [m] how far the ego still has to go when it starts to move
param OPT_ADV_ANGLE = Range(0.6, 0.9)  #: [rad] how far each leg slants

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 3.5
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE) for 0.6 seconds
    while True:
        do MoveAhead(globalParameters.OPT_ADV_SPEED, -2 * globalParameters.OPT_ADV_ANGLE) for 1.2 seconds
        do MoveAhead(globalParameters.OPT_ADV_SPEED, 2 * globalParameters.OPT_ADV_ANGLE) for 1.2 seconds
