#: description = "The parked car pulls out from the kerb and stops in the ego's lane."
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "stop"]
#: position = "kerb"

param OPT_ADV_DISTANCE = Range(16, 36)  #: [m] how far the ego still has to go to it when it moves off
param OPT_ADV_SPEED = Range(3, 5.5)  #: [m/s] how fast it drives
param OPT_BRAKE = Range(0.4, 1)  #: [1] how hard it brakes

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3) for 0.3 seconds
    do DrivePath(ownLane(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(ownLane(egoRoute), self)) < 1.1
    do BrakeOnPath(ownLane(egoRoute), globalParameters.OPT_BRAKE)
