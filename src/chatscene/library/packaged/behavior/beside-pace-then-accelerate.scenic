#: description = "The car keeps pace with the ego and then shoots ahead."
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["pace", "accelerate"]

param OPT_ADV_DISTANCE = Range(-8, 15)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_AHEAD = Range(-10, 1)  #: [m] how far ahead of the ego it stays
param OPT_THROTTLE = Range(0.6, 1)  #: [1] how far the pedal is pressed

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD, 16, 2.5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advLane, globalParameters.OPT_THROTTLE)
