#: description = "The car ahead bucks and stutters with a failing engine and breaks down in the lane."
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "NHTSA pre-crash typology: vehicle failure; own code"
#: [slots]
#: actions = ["accelerate", "stop"]
#: position = "ahead"

param OPT_ADV_DISTANCE = Range(0, 30)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_AHEAD = Range(18, 28)  #: [m] how far ahead of the ego it drives before it acts
param OPT_THROTTLE = Range(0.5, 0.8)  #: [1] how far the pedal is pressed
param OPT_THROTTLE_TIME = Range(0.6, 1.2)  #: [s] for how long it presses the pedal

behavior AdvBehavior():
    do PaceOnPath(advTrajectory, ego, globalParameters.OPT_ADV_AHEAD, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and headway(egoRoute, ego, self) > 0.85 * globalParameters.OPT_ADV_AHEAD
    do BrakeOnPath(advTrajectory, 0.15) for 1.5 seconds
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE) for globalParameters.OPT_THROTTLE_TIME seconds
    do BrakeOnPath(advTrajectory, 0.15) for 1.5 seconds
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE) for 0.6 * globalParameters.OPT_THROTTLE_TIME seconds
    do BrakeOnPath(advTrajectory, 0.5)
