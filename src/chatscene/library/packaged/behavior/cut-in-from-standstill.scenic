#: description = "The car stops in its own lane, waits and then pulls out of the queue in front of the ego."
#: adversaries = ["car", "truck", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["stop", "hesitate", "cut-in"]
#: position = "ahead-beside"
#: maneuver = "straight"
#: leader = false

param OPT_ADV_DISTANCE = Range(15, 35)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_BRAKE = Range(0.6, 0.9)  #: [1] how hard it brakes
param OPT_ADV_AHEAD = Range(12, 30)  #: [m] how far ahead of the ego it still is when it pulls out
param OPT_ADV_SPEED = Range(4, 7.5)  #: [m/s] how fast it pulls out

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, 24, 16, 4) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and headway(egoRoute, ego, self) > 16
    do BrakeOnPath(advLane, globalParameters.OPT_BRAKE) until self.pose[3] < 0.05
    do Halt() for 0.5 seconds
    do Halt() until headway(advLane, ego, self) < globalParameters.OPT_ADV_AHEAD
    do DrivePath(egoRoute, globalParameters.OPT_ADV_SPEED)
