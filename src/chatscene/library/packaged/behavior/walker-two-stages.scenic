#: description = "The pedestrian hurries as far as the edge of the ego's lane, waits there, and hurries over the rest in a second stage."
#: adversaries = ["pedestrian"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "hesitate", "accelerate"]

param OPT_ADV_SPEED = Range(2.8, 4.8)  #: [m/s] how fast it goes
param OPT_ADV_DISTANCE = Range(20, 46)  #: [m] how far the ego still has to go when the adversary reaches its line
param OPT_STOP_DISTANCE = Range(1.5, 2)  #: [m] how far from the ego's line it waits
param OPT_STOP_TIME = Range(0.4, 1.6)  #: [s] how long it waits

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 4
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt() until self.pose[3] < 0.1
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
