#: description = "The pedestrian shuffles into the lane, takes fright and rushes back at a run."
#: adversaries = ["pedestrian"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "slow", "turn-back", "accelerate"]

param OPT_ADV_SPEED = Range(0.7, 1.2)  #: [m/s] how fast it goes out
param OPT_ADV_DISTANCE = Range(32, 48)  #: [m] how far the ego still has to go when it starts to move
param OPT_ADV_REACH = Range(0.2, 1.1)  #: [m] how far from the ego's line it turns back
param OPT_ADV_SPRINT = Range(3.6, 5.5)  #: [m/s] how fast it runs back

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 4
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    do MoveAhead(globalParameters.OPT_ADV_SPRINT, 3.14159) until abs(offsetFrom(egoRoute, self)) > 4.5
    do Halt()
