#: description = "The pedestrian sprints across the road on a slant."
#: adversaries = ["pedestrian"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "diagonal", "fast"]

param OPT_ADV_SPEED = Range(4, 7)  #: [m/s] how fast it runs
param OPT_ADV_DISTANCE = Range(9, 20)  #: [m] how far the ego still has to go when the adversary reaches its line
param OPT_ADV_ANGLE = Range(0.5, 0.95)  #: [rad] how far its way turns from straight across

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 3.5
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE if offsetFrom(egoRoute, self) > 0 else -globalParameters.OPT_ADV_ANGLE)
