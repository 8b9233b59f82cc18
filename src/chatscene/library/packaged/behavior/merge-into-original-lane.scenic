#: description = "The car in the target lane suddenly merges into the ego's original lane."
#: adversaries = ["car", "motorcycle"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["cut-in", "change-lane"]

param OPT_ADV_DISTANCE = Range(-15, 20)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_SPEED = Range(6, 10)  #: [m/s] how fast it drives at most
param OPT_ADV_BEHIND = Range(8, 12)  #: [m] how far behind the leading vehicle it stays

behavior AdvBehavior():
    # At the latest where there is just room left behind the leading vehicle.
    do KeepStation(advLane, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE or headway(leaderWay, self, LeadingAgent) < globalParameters.OPT_ADV_BEHIND + 1
    do PaceOnPath(leaderWay, LeadingAgent, -globalParameters.OPT_ADV_BEHIND, globalParameters.OPT_ADV_SPEED)
