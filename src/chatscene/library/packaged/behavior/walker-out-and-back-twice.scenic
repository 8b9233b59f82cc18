#: description = "The pedestrian steps into the lane and back out of it twice."
#: adversaries = ["pedestrian"]
#: origin = "own code"
#: [slots]
#: actions = ["hesitate", "turn-back"]

param OPT_ADV_SPEED = Range(2.6, 4)  #: [m/s] how fast it goes
param OPT_ADV_DISTANCE = Range(30, 48)  #: [m] how far the ego still has to go when the adversary reaches its line
param OPT_ADV_REACH = Range(0.3, 1.1)  #: [m] how far from the ego's line it turns back
param OPT_STOP_TIME = Range(0.2, 0.6)  #: [s] how long it waits between

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 4
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_ADV_REACH + 0.6)
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 3.14159) until abs(offsetFrom(egoRoute, self)) > globalParameters.OPT_ADV_REACH + 1.4
    do Halt() until self.pose[3] < 0.1
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 3.14159) until restsWithin(egoRoute, self, globalParameters.OPT_ADV_REACH)
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 3.14159) until abs(offsetFrom(egoRoute, self)) > 3
    do Halt()
