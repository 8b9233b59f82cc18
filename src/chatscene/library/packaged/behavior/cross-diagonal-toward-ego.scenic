#: description = "The pedestrian crosses diagonally toward the ego, facing it."
#: adversaries = ["pedestrian"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "diagonal", "oncoming"]
#: group = false

param OPT_ADV_SPEED = Range(1.6, 4)  #: [m/s] how fast it goes
param OPT_ADV_DISTANCE = Range(4, 26)  #: [m] how far the ego still has to go when the adversary reaches its line
param OPT_ADV_ANGLE = Range(0.8, 1.05)  #: [rad] how far its way turns from straight across

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 9 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 4
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 2.4
    # Against the ego's direction, from whichever side it comes.
    do MoveAhead(globalParameters.OPT_ADV_SPEED, -globalParameters.OPT_ADV_ANGLE if offsetFrom(egoRoute, self) > 0 else globalParameters.OPT_ADV_ANGLE)
