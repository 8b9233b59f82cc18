#: description = "The pedestrian runs into the lane, stops to pick something up and runs back with it."
#: adversaries = ["pedestrian"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "brake", "stop", "turn-back"]

param OPT_ADV_SPEED = Range(2.8, 5.5)  #: [m/s] how fast it runs
param OPT_ADV_DISTANCE = Range(18, 34)  #: [m] how far the ego still has to go when the adversary reaches its line
param OPT_STOP_DISTANCE = Range(0.2, 1.25)  #: [m] how far from the ego's line it stops
param OPT_STOP_TIME = Range(0.5, 1.1)  #: [s] how long it bends down

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt() until self.pose[3] < 0.1
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 3.14159) until abs(offsetFrom(egoRoute, self)) > 3.5
    do Halt()
