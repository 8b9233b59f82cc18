#: description = "The ego turns left at a three-way intersection without traffic lights or signs, coming from the road that ends there."
#: rephrasings = [
#:   "The ego turns left at an intersection with three arms that nothing regulates, coming out of the side road.",
#:   "Where a side street comes in, with no lights, nothing tells you who goes first, we hang a left, out of the side street onto the main drag.",
#:   "ego left turn, uncontrolled 3-leg, own arm terminates",
#:   "Vehicle 1 was executing a left turn at a three-leg intersection without traffic controls; from the leg that terminated at the junction.",
#:   "The test vehicle steers to the left arm at a three-arm junction of the uncontrolled type, approach on the terminating arm.",
#:   "The ego bends to left in crossing that has only three streets where no lights and no signs exist, its street has the end there.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "trafficFromLeft", "trafficFromRight"]
#: origin = "own code"
#: [slots]
#: maneuver = "left-turn"
#: place = "three-way"
#: control = "none"

egoRoute = selectRoute(maneuver="left-turn", place="three-way", control="none", crossed=("left", "right"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
trafficFromRight = trafficFrom(egoRoute, "right")
