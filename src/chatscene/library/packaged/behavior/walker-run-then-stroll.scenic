#: description = "The pedestrian runs out into the road and then slows to a stroll in the ego's lane."
#: adversaries = ["pedestrian"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "brake", "slow"]

param OPT_ADV_SPEED = Range(3.2, 6)  #: [m/s] how fast it runs at first
param OPT_ADV_DISTANCE = Range(18, 32)  #: [m] how far the ego still has to go when the adversary reaches its line
param OPT_ADV_REACH = Range(0.9, 1.9)  #: [m] how far from the ego's line it slows down
param OPT_SLOW_SPEED = Range(0.6, 1.2)  #: [m/s] how fast it strolls

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    do MoveAhead(globalParameters.OPT_SLOW_SPEED)
