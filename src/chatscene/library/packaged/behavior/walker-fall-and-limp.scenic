#: description = "The pedestrian runs into the road, falls, gets up again and limps on slowly."
#: adversaries = ["pedestrian"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "brake", "hesitate", "slow"]

param OPT_ADV_SPEED = Range(2.8, 5)  #: [m/s] how fast it runs
param OPT_ADV_DISTANCE = Range(24, 42)  #: [m] how far the ego still has to go when the adversary reaches its line
param OPT_STOP_DISTANCE = Range(0.3, 1.6)  #: [m] how far from the ego's line it falls
param OPT_STOP_TIME = Range(0.6, 1.3)  #: [s] how long it is down
param OPT_SLOW_SPEED = Range(0.6, 1.1)  #: [m/s] how fast it limps on

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt() until self.pose[3] < 0.1
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do MoveAhead(globalParameters.OPT_SLOW_SPEED)
