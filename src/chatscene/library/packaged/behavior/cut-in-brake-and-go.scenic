#: description = "The car cuts in front of the ego, jabs the brakes and then speeds away."
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["cut-in", "brake", "accelerate"]
#: maneuver = "straight"
#: leader = false

param OPT_ADV_DISTANCE = Range(-10, 25)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_AHEAD = Range(7, 14)  #: [m] how far its rear is ahead of the ego's front before it moves over
param OPT_BRAKE = Range(0.6, 1)  #: [1] how hard it brakes
param OPT_BRAKE_TIME = Range(0.7, 1.2)  #: [s] for how long it brakes

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD + (ego.length + self.length) / 2, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and headway(egoRoute, ego, self) > 0.8 * globalParameters.OPT_ADV_AHEAD + 3
    do DrivePath(egoRoute, 7) until abs(offsetFrom(egoRoute, self)) < 1
    do BrakeOnPath(egoRoute, globalParameters.OPT_BRAKE) for globalParameters.OPT_BRAKE_TIME seconds
    do ThrottleOnPath(egoRoute, 1, 0, 11)
