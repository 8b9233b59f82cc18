#: description = "The car ahead stops abruptly, waits a moment and drives off again."
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["brake", "stop", "hesitate", "accelerate"]
#: position = "ahead"

param OPT_ADV_DISTANCE = Range(-15, 20)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_AHEAD = Range(15, 26)  #: [m] how far ahead of the ego it drives before it acts, and farther the longer it will stand
param OPT_BRAKE = Range(0.5, 1)  #: [1] how hard it brakes
param OPT_STOP_TIME = Range(0.6, 3)  #: [s] how long it stands
param OPT_ADV_SPEED = Range(6, 10)  #: [m/s] how fast it drives afterwards

behavior AdvBehavior():
    do PaceOnPath(advTrajectory, ego, globalParameters.OPT_ADV_AHEAD + 6 * globalParameters.OPT_STOP_TIME, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and headway(egoRoute, ego, self) > 0.85 * (globalParameters.OPT_ADV_AHEAD + 6 * globalParameters.OPT_STOP_TIME)
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.05
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
