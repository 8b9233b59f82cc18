#: description = "The car keeps pace with the ego and then brakes hard in its lane."
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["pace", "brake"]
#: position = "beside"

param OPT_ADV_DISTANCE = Range(-22, 4)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_AHEAD = Range(1, 6)  #: [m] how far ahead of the ego it stays
param OPT_BRAKE = Range(0.5, 1)  #: [1] how hard it brakes

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD, 16, 0.5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advLane, globalParameters.OPT_BRAKE)
