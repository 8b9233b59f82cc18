#: description = "The car brakes suddenly and then drives off again."
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["brake", "accelerate"]

param OPT_ADV_DISTANCE = Range(-15, 20)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_BRAKE = Range(0.4, 1)  #: [1] how hard it brakes
param OPT_BRAKE_TIME = Range(0.7, 1.6)  #: [s] for how long
param OPT_ADV_SPEED = Range(7, 12)  #: [m/s] how fast it drives afterwards

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) for globalParameters.OPT_BRAKE_TIME seconds
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
