#: description = "The ego turns right at a three-way intersection, leaving the through road for the side road."
#: rephrasings = [
#:   "The ego makes a right at a T-junction, leaving the main road.",
#:   "Where another road joins, we're nipping off to the right, we leave the main road for the little one.",
#:   "RT, T-junction, into stem of T",
#:   "Vehicle 1 began to turn right at a T-intersection from the through road into the intersecting leg.",
#:   "The VUT performs a turn to the right at a T-junction with three arms, leaving the through road for the stem of the T.",
#:   "The ego car makes the turning to right side at the T of streets, from the main street into the small one.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "oncomingTraffic"]
#: origin = "own code"
#: [slots]
#: maneuver = "right-turn"
#: place = "three-way"

egoRoute = selectRoute(maneuver="right-turn", place="three-way", crossed=("oncoming",))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
