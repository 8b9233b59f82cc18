#: description = "The ego drives straight through a three-way intersection with stop signs; the side road joins from the right."
#: rephrasings = [
#:   "The ego goes straight on at a T-junction where every arm has a stop sign, the side road joins from the right.",
#:   "Where another road joins, where everyone has to stop first, we just carry on straight, the side street is on our right.",
#:   "ego straight through, stop-controlled T-junction, side arm R",
#:   "Vehicle 1 was proceeding straight through a T-intersection where all legs had stop signs; a side street intersected from the right.",
#:   "The test vehicle passes without turning through a T-junction with three arms controlled by STOP signs, side arm to the right of the VUT.",
#:   "The ego drives direct across at the T of streets where stand the stop signs, on right hand enters another street.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "oncomingTraffic", "trafficFromRight"]
#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: place = "three-way"
#: control = "stop-sign"

egoRoute = selectRoute(maneuver="straight", place="three-way", control="stop-sign", crossed=("right", "oncoming"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromRight = trafficFrom(egoRoute, "right")
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
