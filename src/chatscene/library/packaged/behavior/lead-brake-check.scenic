#: description = "The car ahead taps its brakes twice to scare the ego and drives on."
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["brake", "follow"]
#: position = "ahead"

param OPT_ADV_DISTANCE = Range(-15, 20)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_BRAKE = Range(0.6, 1)  #: [1] how hard it brakes
param OPT_BRAKE_TIME = Range(0.6, 1.1)  #: [s] for how long it brakes

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) for globalParameters.OPT_BRAKE_TIME seconds
    do DrivePath(advTrajectory, 7) for 1.2 seconds
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) for globalParameters.OPT_BRAKE_TIME seconds
    do DrivePath(advTrajectory, 7)
