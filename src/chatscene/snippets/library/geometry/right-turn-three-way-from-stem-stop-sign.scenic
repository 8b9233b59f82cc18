#: description = "The ego turns right at a three-way intersection with stop signs, coming from the road that ends there."
#: rephrasings = [
#:   "The ego makes a right at a T-junction where every arm has a stop sign, coming out of the side road.",
#:   "Where another road joins, where everyone has to stop first, we're nipping off to the right, out of the side street onto the main drag.",
#:   "RT, stop-controlled T-junction, own arm terminates",
#:   "Vehicle 1 began to turn right at a T-intersection where all legs had stop signs; from the leg that terminated at the junction.",
#:   "The VUT performs a turn to the right at a T-junction with three arms controlled by STOP signs, approach on the terminating arm.",
#:   "The ego car makes the turning to right side at the T of streets where stand the stop signs, its street has the end there.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "trafficFromLeft"]
#: origin = "own code"
#: [slots]
#: maneuver = "right-turn"
#: place = "three-way"
#: control = "stop-sign"

egoRoute = selectRoute(maneuver="right-turn", place="three-way", control="stop-sign", crossed=("left",))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
