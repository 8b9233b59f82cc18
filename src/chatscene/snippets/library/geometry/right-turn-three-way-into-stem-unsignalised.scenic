#: description = "The ego turns right at a three-way intersection without traffic lights or signs, leaving the through road for the side road."
#: rephrasings = [
#:   "The ego makes a right at an intersection with three arms without any signals or signs, leaving the main road.",
#:   "Where a side street comes in, no signs, no signals, everybody just sorts it out, we're nipping off to the right, we leave the main road for the little one.",
#:   "RT, no TCD 3-leg, into stem of T",
#:   "Vehicle 1 began to turn right at a three-leg intersection with no traffic control device from the through road into the intersecting leg.",
#:   "The VUT performs a turn to the right at a three-arm junction without signal or sign control, leaving the through road for the stem of the T.",
#:   "The ego car makes the turning to right side in crossing that has only three streets without any light or table, from the main street into the small one.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "oncomingTraffic"]
#: origin = "own code"
#: [slots]
#: maneuver = "right-turn"
#: place = "three-way"
#: control = "none"

egoRoute = selectRoute(maneuver="right-turn", place="three-way", control="none", crossed=("oncoming",))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
