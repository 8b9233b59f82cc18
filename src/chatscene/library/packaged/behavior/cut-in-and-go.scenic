#: description = "The car accelerates, forces its way in front of the ego and pulls away."
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["cut-in", "accelerate"]
#: maneuver = "straight"
#: leader = false

param OPT_ADV_DISTANCE = Range(0, 30)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_AHEAD = Range(2, 8)  #: [m] how far its rear is ahead of the ego's front before it moves over
param OPT_THROTTLE = Range(0.5, 1)  #: [1] how far the pedal is pressed
param OPT_THROTTLE_TIME = Range(0.3, 0.8)  #: [s] for how long it moves over before it presses the pedal

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD + (ego.length + self.length) / 2, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(egoRoute, 6.5) for globalParameters.OPT_THROTTLE_TIME seconds
    do ThrottleOnPath(egoRoute, globalParameters.OPT_THROTTLE, 0, 14)
