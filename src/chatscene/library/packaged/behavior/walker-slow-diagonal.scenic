#: description = "The pedestrian shuffles across slowly on a long diagonal."
#: adversaries = ["pedestrian"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "diagonal", "slow"]

param OPT_ADV_SPEED = Range(0.7, 1.2)  #: [m/s] how fast it goes
param OPT_ADV_DISTANCE = Range(8, 34)  #: [m] how far the ego still has to go when it starts to move
param OPT_ADV_ANGLE = Range(0.45, 0.85)  #: [rad] how far its way turns from straight across

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 3.5
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE if offsetFrom(egoRoute, self) > 0 else -globalParameters.OPT_ADV_ANGLE)
