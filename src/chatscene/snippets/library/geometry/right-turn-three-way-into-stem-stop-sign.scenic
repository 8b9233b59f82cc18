#: description = "The ego turns right at a three-way intersection with stop signs, leaving the through road for the side road."
#: rephrasings = [
#:   "The ego turns right at a T-junction with stop signs, leaving the main road.",
#:   "Where another road joins, an all-way stop, we take a right, we leave the main road for the little one.",
#:   "ego right turn, AWSC T-junction, into stem of T",
#:   "Vehicle 1 was negotiating a right-hand turn at a T-intersection governed by stop signs from the through road into the intersecting leg.",
#:   "The test vehicle steers to the right arm at a T-junction with three arms with STOP signs on every approach, leaving the through road for the stem of the T.",
#:   "The ego bends to right at the T of streets with table STOP in each street, from the main street into the small one.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "oncomingTraffic"]
#: origin = "own code"
#: [slots]
#: maneuver = "right-turn"
#: place = "three-way"
#: control = "stop-sign"

egoRoute = selectRoute(maneuver="right-turn", place="three-way", control="stop-sign", crossed=("oncoming",))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
