#: description = "The ego turns left at a three-way intersection, coming from the road that ends there."
#: rephrasings = [
#:   "The ego makes a left at an intersection with three arms, coming out of the side road.",
#:   "Where a side street comes in, we want to go left, out of the side street onto the main drag.",
#:   "LT, 3-leg, own arm terminates",
#:   "Vehicle 1 began to turn left at a three-leg intersection; from the leg that terminated at the junction.",
#:   "The VUT performs a turn to the left at a three-arm junction, approach on the terminating arm.",
#:   "The ego car makes the turning to left side in crossing that has only three streets, its street has the end there.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "trafficFromLeft", "trafficFromRight"]
#: origin = "own code"
#: [slots]
#: maneuver = "left-turn"
#: place = "three-way"

egoRoute = selectRoute(maneuver="left-turn", place="three-way", crossed=("left", "right"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
trafficFromRight = trafficFrom(egoRoute, "right")
