#: description = "The car behind rushes up at high speed and does not slow down for the ego."
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["accelerate", "fast"]
#: position = "behind"

param OPT_ADV_DISTANCE = Range(-12, 20)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_THROTTLE = Range(0.8, 1)  #: [1] how far the pedal is pressed
param OPT_ADV_SPEED = Range(12.5, 16)  #: [m/s] how fast it drives

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, globalParameters.OPT_ADV_SPEED)
