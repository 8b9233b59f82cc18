#: description = "The ego turns left at a three-way intersection without traffic lights or signs, leaving the through road for the side road."
#: rephrasings = [
#:   "The ego turns left at an intersection with three arms without any signals or signs, leaving the main road.",
#:   "Where a side street comes in, no signs, no signals, everybody just sorts it out, we hang a left, we leave the main road for the little one.",
#:   "ego left turn, no TCD 3-leg, into stem of T",
#:   "Vehicle 1 was executing a left turn at a three-leg intersection with no traffic control device from the through road into the intersecting leg.",
#:   "The test vehicle steers to the left arm at a three-arm junction without signal or sign control, leaving the through road for the stem of the T.",
#:   "The ego bends to left in crossing that has only three streets without any light or table, from the main street into the small one.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "oncomingTraffic", "trafficFromLeft"]
#: origin = "own code"
#: [slots]
#: maneuver = "left-turn"
#: place = "three-way"
#: control = "none"

egoRoute = selectRoute(maneuver="left-turn", place="three-way", control="none", crossed=("left", "oncoming"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
