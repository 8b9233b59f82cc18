#: description = "The parked car pulls out and wobbles from side to side in the ego's lane."
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "weave"]
#: side = "right"
#: position = "kerb"
#: place = "road"

param OPT_ADV_DISTANCE = Range(14, 34)  #: [m] how far the ego still has to go to it when it moves off
param OPT_ADV_SPEED = Range(2.5, 4.5)  #: [m/s] how fast it drives
param OPT_ADV_AMPLITUDE = Range(0.9, 1.3)  #: [m] how far it swings to either side

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3) for 0.3 seconds
    do DrivePath(ownLane(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(ownLane(egoRoute), self)) < 1
    do WeaveOnPath(ownLane(egoRoute), globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, 3)
