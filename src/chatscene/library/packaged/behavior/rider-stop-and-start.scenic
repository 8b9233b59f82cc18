#: description = "The cyclist ahead stops in the lane, looks about and rides off again briskly."
#: adversaries = ["bicycle"]
#: origin = "own code"
#: [slots]
#: actions = ["stop", "hesitate", "accelerate"]
#: position = "ahead"

param OPT_ADV_SPEED = Range(4, 6)  #: [m/s] how fast it rides
param OPT_ADV_DISTANCE = Range(5, 30)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_AHEAD = Range(18, 28)  #: [m] how far ahead of the ego it rides before it acts
param OPT_BRAKE = Range(0.6, 0.9)  #: [1] how hard it brakes
param OPT_STOP_TIME = Range(0.2, 0.6)  #: [s] how long it stands

behavior AdvBehavior():
    do PaceOnPath(advTrajectory, ego, globalParameters.OPT_ADV_AHEAD, 9, 4) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.1
    do BrakeOnPath(advTrajectory, 1) for globalParameters.OPT_STOP_TIME seconds
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
