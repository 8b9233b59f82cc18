#: description = "The motorcyclist pretends to cross the road but brakes abruptly at its edge."
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: origin = "base scenario turning-obstacle; own code"
#: [slots]
#: actions = ["brake", "stop"]

param OPT_ADV_SPEED = Range(3.5, 7)  #: [m/s] how fast it rides at the road
param OPT_ADV_DISTANCE = Range(2, 16)  #: [m] how far the ego still has to go when it starts
param OPT_STOP_DISTANCE = Range(1.4, 2.3)  #: [m] how far from the ego's line it comes to rest

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt()
