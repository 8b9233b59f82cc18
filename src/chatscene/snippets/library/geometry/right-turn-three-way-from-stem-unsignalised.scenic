#: description = "The ego turns right at a three-way intersection without traffic lights or signs, coming from the road that ends there."
#: rephrasings = [
#:   "The ego makes a right at an intersection with three arms that nothing regulates, coming out of the side road.",
#:   "Where a side street comes in, with no lights, nothing tells you who goes first, we're nipping off to the right, out of the side street onto the main drag.",
#:   "RT, uncontrolled 3-leg, own arm terminates",
#:   "Vehicle 1 began to turn right at a three-leg intersection without traffic controls; from the leg that terminated at the junction.",
#:   "The VUT performs a turn to the right at a three-arm junction of the uncontrolled type, approach on the terminating arm.",
#:   "The ego car makes the turning to right side in crossing that has only three streets where no lights and no signs exist, its street has the end there.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "trafficFromLeft"]
#: origin = "own code"
#: [slots]
#: maneuver = "right-turn"
#: place = "three-way"
#: control = "none"

egoRoute = selectRoute(maneuver="right-turn", place="three-way", control="none", crossed=("left",))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
