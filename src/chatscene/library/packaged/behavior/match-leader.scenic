#: description = "The car in the target lane slows down and matches the speed of the slow leading vehicle, blocking the lane."
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["slow"]

param OPT_ADV_DISTANCE = Range(10, 35)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_AHEAD = Range(-4, 14)  #: [m] how far ahead of the leading vehicle it stays

behavior AdvBehavior():
    do KeepStation(advLane, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do PaceOnPath(advLane, LeadingAgent, globalParameters.OPT_ADV_AHEAD, LeadingAgent.pose[3] + 0.4)
