#: description = "The car in the target lane suddenly merges into the ego's original lane."
#: rephrasings = [
#:   "A vehicle from beside cuts over into the lane the ego is leaving.",
#:   "The adversary changes into the lane where the ego started and blocks its return.",
#:   "The neighbouring car swaps lanes into the one behind the slow leader.",
#:   "While the ego moves out, the other driver moves in to the place it left.",
#:   "The car next to the ego switches abruptly to the ego's initial lane.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "ego", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["cut-in", "change-lane"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 25.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it drives in the end"

param OPT_ADV_DISTANCE = Range(0, 25)
param OPT_ADV_SPEED = Range(5, 9)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(ownLane(egoRoute), globalParameters.OPT_ADV_SPEED)
