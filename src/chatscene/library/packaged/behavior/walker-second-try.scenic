#: description = "The pedestrian steps out, goes back to the edge, waits a moment and then darts across after all."
#: adversaries = ["pedestrian"]
#: origin = "own code"
#: [slots]
#: actions = ["turn-back", "hesitate", "cross", "accelerate"]

param OPT_ADV_SPEED = Range(3, 3.8)  #: [m/s] how fast it goes at first
param OPT_ADV_DISTANCE = Range(40, 56)  #: [m] how far the ego still has to go when the adversary reaches its line
param OPT_ADV_REACH = Range(1.6, 2.3)  #: [m] how far from the ego's line it first turns back
param OPT_STOP_TIME = Range(0.3, 0.6)  #: [s] how long it waits
param OPT_ADV_SPRINT = Range(3.8, 6.5)  #: [m/s] how fast it runs across

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 3.14159) until abs(offsetFrom(egoRoute, self)) > globalParameters.OPT_ADV_REACH + 0.6
    do Halt() until self.pose[3] < 0.1
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do MoveAhead(globalParameters.OPT_ADV_SPRINT, 3.14159)
