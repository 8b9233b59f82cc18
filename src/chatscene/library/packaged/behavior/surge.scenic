#: description = "The car speeds up and slows down by turns."
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["accelerate", "brake"]

param OPT_ADV_DISTANCE = Range(-15, 20)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_THROTTLE = Range(0.6, 1)  #: [1] how far the pedal is pressed
param OPT_BRAKE = Range(0.35, 1)  #: [1] how hard it brakes
param OPT_ADV_PERIOD = Range(1.2, 2.2)  #: [s] how long each phase lasts

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    while True:
        do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) for 0.6 * globalParameters.OPT_ADV_PERIOD seconds
        do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE) for globalParameters.OPT_ADV_PERIOD seconds
