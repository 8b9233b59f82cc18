#: description = "The pedestrian wanders slowly into the lane, turns round and wanders back just as slowly."
#: adversaries = ["pedestrian"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "slow", "turn-back"]

param OPT_ADV_SPEED = Range(0.8, 1.3)  #: [m/s] how fast it goes
param OPT_ADV_DISTANCE = Range(8, 34)  #: [m] how far the ego still has to go when it starts to move
param OPT_ADV_REACH = Range(0, 1)  #: [m] how far from the ego's line it turns back

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 3.5
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 3.14159)
