#: description = "The parked car pulls out, drives a little and then brakes hard to a crawl."
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "brake", "slow"]
#: position = "kerb"

param OPT_ADV_DISTANCE = Range(15, 34)  #: [m] how far the ego still has to go to it when it moves off
param OPT_THROTTLE_TIME = Range(2.5, 4)  #: [s] how long it drives before it brakes
param OPT_BRAKE = Range(0.6, 1)  #: [1] how hard it brakes

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3) for 0.3 seconds
    do DrivePath(ownLane(egoRoute), 7) for globalParameters.OPT_THROTTLE_TIME seconds
    do BrakeOnPath(ownLane(egoRoute), globalParameters.OPT_BRAKE) until self.pose[3] < 1.5
    do DrivePath(ownLane(egoRoute), 1.5)
