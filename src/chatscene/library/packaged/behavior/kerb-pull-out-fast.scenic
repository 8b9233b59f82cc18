#: description = "The parked car shoots out from the kerb and speeds off in the ego's lane."
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "accelerate"]
#: position = "kerb"

param OPT_ADV_DISTANCE = Range(8, 26)  #: [m] how far the ego still has to go to it when it moves off
param OPT_THROTTLE = Range(0.75, 1)  #: [1] how far the pedal is pressed

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3) for 0.3 seconds
    do ThrottleOnPath(ownLane(egoRoute), globalParameters.OPT_THROTTLE, 0, 12)
