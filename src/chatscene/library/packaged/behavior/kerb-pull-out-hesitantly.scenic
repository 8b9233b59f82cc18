#: description = "The parked car starts to pull out, stops, hesitates and then pulls out after all."
#: adversaries = ["car", "bus", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["hesitate", "pull-out"]
#: side = "right"
#: position = "kerb"
#: maneuver = "straight"

param OPT_ADV_DISTANCE = Range(24, 42)  #: [m] how far the ego still has to go to it when it moves off
param OPT_STOP_TIME = Range(0.3, 0.9)  #: [s] how long it hesitates
param OPT_ADV_SPEED = Range(4, 6.5)  #: [m/s] how fast it drives

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 2, 0) for 0.6 seconds
    do BrakeOnPath(advKerb, 1) until self.pose[3] < 0.05
    do Park() for globalParameters.OPT_STOP_TIME seconds
    do DrivePath(ownLane(egoRoute), globalParameters.OPT_ADV_SPEED)
