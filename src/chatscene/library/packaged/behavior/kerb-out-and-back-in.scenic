#: description = "The parked car pulls out into the ego's lane and at once pulls in again at the kerb."
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "turn-back"]
#: position = "kerb"

param OPT_ADV_DISTANCE = Range(15, 34)  #: [m] how far the ego still has to go to it when it moves off
param OPT_ADV_SPEED = Range(3, 5.5)  #: [m/s] how fast it drives

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3) for 0.3 seconds
    do DrivePath(ownLane(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(ownLane(egoRoute), self)) < 0.9
    do DrivePath(advKerb, globalParameters.OPT_ADV_SPEED)
