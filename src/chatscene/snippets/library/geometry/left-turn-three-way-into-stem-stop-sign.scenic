#: description = "The ego turns left at a three-way intersection with stop signs, leaving the through road for the side road."
#: rephrasings = [
#:   "The ego makes a left at an intersection with three arms with stop signs, leaving the main road.",
#:   "Where a side street comes in, an all-way stop, we want to go left, we leave the main road for the little one.",
#:   "LT, AWSC 3-leg, into stem of T",
#:   "Vehicle 1 began to turn left at a three-leg intersection governed by stop signs from the through road into the intersecting leg.",
#:   "The VUT performs a turn to the left at a three-arm junction with STOP signs on every approach, leaving the through road for the stem of the T.",
#:   "The ego car makes the turning to left side in crossing that has only three streets with table STOP in each street, from the main street into the small one.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "oncomingTraffic", "trafficFromLeft"]
#: origin = "own code"
#: [slots]
#: maneuver = "left-turn"
#: place = "three-way"
#: control = "stop-sign"

egoRoute = selectRoute(maneuver="left-turn", place="three-way", control="stop-sign", crossed=("left", "oncoming"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
