#: description = "The cyclist ahead brakes hard and stops in the lane."
#: adversaries = ["bicycle"]
#: origin = "own code"
#: [slots]
#: actions = ["brake", "stop", "block"]
#: position = "ahead"

param OPT_ADV_DISTANCE = Range(0, 25)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_BRAKE = Range(0.7, 1)  #: [1] how hard it brakes

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego, 4) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
