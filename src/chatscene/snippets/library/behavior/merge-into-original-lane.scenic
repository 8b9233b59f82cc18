#: description = "The car in the target lane suddenly merges into the ego's original lane."
#: rephrasings = [
#:   "A vehicle from beside cuts over into the lane the ego is leaving.",
#:   "The adversary moves in behind the slow leader, where the ego came from, and blocks its return.",
#:   "The neighbouring car swaps lanes and slots in ahead of the ego behind the slow one.",
#:   "While the ego moves out, the other driver moves in to the place it left.",
#:   "The car next to the ego switches abruptly to the ego's initial lane.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["LeadingAgent", "advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["cut-in", "change-lane"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -15.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 6.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it drives at most"
#: [[parameters]]
#: name = "OPT_ADV_BEHIND"
#: low = 8.0
#: high = 12.0
#: unit = "m"
#: meaning = "how far behind the leading vehicle it stays"

param OPT_ADV_DISTANCE = Range(-15, 20)
param OPT_ADV_SPEED = Range(6, 10)
param OPT_ADV_BEHIND = Range(8, 12)

behavior AdvBehavior():
    # At the latest where there is just room left behind the leading vehicle.
    do KeepStation(advLane, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE or headway(advLane, self, LeadingAgent) < globalParameters.OPT_ADV_BEHIND + 1
    do PaceOnPath(ownLane(egoRoute), LeadingAgent, -globalParameters.OPT_ADV_BEHIND, globalParameters.OPT_ADV_SPEED)
