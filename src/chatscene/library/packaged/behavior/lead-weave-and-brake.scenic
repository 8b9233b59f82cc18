#: description = "The car ahead weaves in its lane like a drunk and suddenly brakes."
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["weave", "brake", "stop"]
#: position = "ahead"

param OPT_ADV_DISTANCE = Range(-25, 5)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_SPEED = Range(5.5, 7.5)  #: [m/s] how fast it drives
param OPT_ADV_AMPLITUDE = Range(0.7, 1.2)  #: [m] how far it swings to either side
param OPT_BRAKE = Range(0.5, 1)  #: [1] how hard it brakes

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) for 2 seconds
    do WeaveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, 3.4) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and abs(offsetFrom(advTrajectory, self)) < 0.7
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
