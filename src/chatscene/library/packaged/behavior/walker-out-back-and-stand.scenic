#: description = "The pedestrian steps out, steps back, steps out again and then stays standing in the lane."
#: adversaries = ["pedestrian"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "hesitate", "stop"]

param OPT_ADV_SPEED = Range(2.2, 3.6)  #: [m/s] how fast it goes
param OPT_ADV_DISTANCE = Range(32, 48)  #: [m] how far the ego still has to go when the adversary reaches its line
param OPT_ADV_REACH = Range(1.4, 2.2)  #: [m] how far from the ego's line it first turns back
param OPT_STOP_TIME = Range(0.4, 0.9)  #: [s] how long it waits
param OPT_STOP_DISTANCE = Range(0, 1.4)  #: [m] how far from the ego's line it comes to rest

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 4
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 3.14159) until abs(offsetFrom(egoRoute, self)) > globalParameters.OPT_ADV_REACH + 0.9
    do Halt() until self.pose[3] < 0.1
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 3.14159) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt()
