#: description = "The ego turns right at a three-way intersection, coming from the road that ends there."
#: rephrasings = [
#:   "The ego makes a right at a T-junction, coming out of the side road.",
#:   "Where another road joins, we're nipping off to the right, out of the side street onto the main drag.",
#:   "RT, T-junction, own arm terminates",
#:   "Vehicle 1 began to turn right at a T-intersection; from the leg that terminated at the junction.",
#:   "The VUT performs a turn to the right at a T-junction with three arms, approach on the terminating arm.",
#:   "The ego car makes the turning to right side at the T of streets, its street has the end there.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "trafficFromLeft"]
#: origin = "own code"
#: [slots]
#: maneuver = "right-turn"
#: place = "three-way"

egoRoute = selectRoute(maneuver="right-turn", place="three-way", crossed=("left",))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
