#: description = "The ego drives straight through a three-way intersection; the side road joins from the right."
#: rephrasings = [
#:   "The ego goes straight on at an intersection with three arms, the side road joins from the right.",
#:   "Where a side street comes in, we just carry on straight, the side street is on our right.",
#:   "ego straight through, 3-leg, side arm R",
#:   "Vehicle 1 was proceeding straight through a three-leg intersection; a side street intersected from the right.",
#:   "The test vehicle passes without turning through a three-arm junction, side arm to the right of the VUT.",
#:   "The ego drives direct across in crossing that has only three streets, on right hand enters another street.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "oncomingTraffic", "trafficFromRight"]
#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: place = "three-way"

egoRoute = selectRoute(maneuver="straight", place="three-way", crossed=("right", "oncoming"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromRight = trafficFrom(egoRoute, "right")
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
