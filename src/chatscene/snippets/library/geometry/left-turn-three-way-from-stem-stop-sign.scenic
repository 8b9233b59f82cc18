#: description = "The ego turns left at a three-way intersection with stop signs, coming from the road that ends there."
#: rephrasings = [
#:   "The ego turns left at an intersection with three arms where every arm has a stop sign, coming out of the side road.",
#:   "Where a side street comes in, where everyone has to stop first, we hang a left, out of the side street onto the main drag.",
#:   "ego left turn, stop-controlled 3-leg, own arm terminates",
#:   "Vehicle 1 was executing a left turn at a three-leg intersection where all legs had stop signs; from the leg that terminated at the junction.",
#:   "The test vehicle steers to the left arm at a three-arm junction controlled by STOP signs, approach on the terminating arm.",
#:   "The ego bends to left in crossing that has only three streets where stand the stop signs, its street has the end there.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "trafficFromLeft", "trafficFromRight"]
#: origin = "own code"
#: [slots]
#: maneuver = "left-turn"
#: place = "three-way"
#: control = "stop-sign"

egoRoute = selectRoute(maneuver="left-turn", place="three-way", control="stop-sign", crossed=("left", "right"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
trafficFromRight = trafficFrom(egoRoute, "right")
