#: description = "The ego turns left at a three-way intersection, leaving the through road for the side road."
#: rephrasings = [
#:   "The ego makes a left at an intersection with three arms, leaving the main road.",
#:   "Where a side street comes in, we want to go left, we leave the main road for the little one.",
#:   "LT, 3-leg, into stem of T",
#:   "Vehicle 1 began to turn left at a three-leg intersection from the through road into the intersecting leg.",
#:   "The VUT performs a turn to the left at a three-arm junction, leaving the through road for the stem of the T.",
#:   "The ego car makes the turning to left side in crossing that has only three streets, from the main street into the small one.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "oncomingTraffic", "trafficFromLeft"]
#: origin = "own code"
#: [slots]
#: maneuver = "left-turn"
#: place = "three-way"

egoRoute = selectRoute(maneuver="left-turn", place="three-way", crossed=("left", "oncoming"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
