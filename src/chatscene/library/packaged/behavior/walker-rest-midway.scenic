#: description = "The pedestrian shuffles across slowly, stops for breath in the lane and shuffles on."
#: adversaries = ["pedestrian"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "slow", "hesitate"]

param OPT_ADV_SPEED = Range(0.7, 1.2)  #: [m/s] how fast it goes
param OPT_ADV_DISTANCE = Range(16, 40)  #: [m] how far the ego still has to go when it starts to move
param OPT_STOP_DISTANCE = Range(0.2, 1.5)  #: [m] how far from the ego's line it rests
param OPT_STOP_TIME = Range(0.6, 1.8)  #: [s] how long it rests

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 3.5
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt() until self.pose[3] < 0.1
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
