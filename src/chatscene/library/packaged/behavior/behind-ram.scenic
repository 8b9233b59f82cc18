#: description = "The car behind tailgates the ego and then accelerates into it."
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["tailgate", "accelerate"]
#: position = "behind"

param OPT_ADV_DISTANCE = Range(-10, 15)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_GAP = Range(1, 4)  #: [m] how much room it leaves between its bumper and the ego's
param OPT_THROTTLE = Range(0.3, 1)  #: [1] how far the pedal is pressed
param OPT_THROTTLE_TIME = Range(0.6, 1.8)  #: [s] for how long it presses the pedal

behavior AdvBehavior():
    do PaceOnPath(advTrajectory, ego, -(ego.length + self.length) / 2 - globalParameters.OPT_ADV_GAP, 12) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE) for globalParameters.OPT_THROTTLE_TIME seconds
    do PaceOnPath(advTrajectory, ego, -(ego.length + self.length) / 2 - globalParameters.OPT_ADV_GAP, 12)
