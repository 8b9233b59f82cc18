#: description = "The parked car pulls out, stops and backs up toward the ego."
#: adversaries = ["car", "truck", "bus", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "stop", "reverse"]
#: position = "kerb"

param OPT_ADV_DISTANCE = Range(32, 50)  #: [m] how far the ego still has to go to it when it moves off
param OPT_BRAKE = Range(0.5, 0.9)  #: [1] how hard it brakes
param OPT_ADV_BACK_SPEED = Range(0.8, 2.4)  #: [m/s] how fast it backs up

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3) for 0.3 seconds
    do DrivePath(ownLane(egoRoute), 4.5) until abs(offsetFrom(ownLane(egoRoute), self)) < 1
    do BrakeOnPath(ownLane(egoRoute), globalParameters.OPT_BRAKE) until self.pose[3] < 0.05
    do Halt() for 0.6 seconds
    do ReverseStraight(globalParameters.OPT_ADV_BACK_SPEED) for 4 seconds
    do Halt()
