#: description = "The car cuts in, stops in front of the ego and backs up into it."
#: adversaries = ["car", "truck", "bus", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["cut-in", "stop", "reverse"]
#: maneuver = "straight"
#: leader = false

param OPT_ADV_DISTANCE = Range(0, 30)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_AHEAD = Range(19, 29)  #: [m] how far its rear is ahead of the ego's front before it moves over
param OPT_BRAKE = Range(0.5, 0.9)  #: [1] how hard it brakes
param OPT_ADV_BACK_SPEED = Range(0.6, 1.8)  #: [m/s] how fast it backs up

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD + (ego.length + self.length) / 2, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and headway(egoRoute, ego, self) > 0.8 * globalParameters.OPT_ADV_AHEAD + 3
    do DrivePath(egoRoute, 7) until abs(offsetFrom(egoRoute, self)) < 1
    do BrakeOnPath(egoRoute, globalParameters.OPT_BRAKE) until self.pose[3] < 0.05
    do ReverseStraight(globalParameters.OPT_ADV_BACK_SPEED) for 4 seconds
    do Halt()
