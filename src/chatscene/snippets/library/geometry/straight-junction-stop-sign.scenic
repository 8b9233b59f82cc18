#: description = "The ego drives straight through an intersection of any kind with stop signs."
#: rephrasings = [
#:   "The ego goes straight on at a junction of whatever shape with stop signs.",
#:   "Where the streets meet, an all-way stop, we just carry on straight.",
#:   "ego straight through, AWSC xing",
#:   "Vehicle 1 was proceeding straight through an intersection governed by stop signs.",
#:   "The test vehicle passes without turning through a road junction with STOP signs on every approach.",
#:   "The ego drives direct across in the crossing of roads with table STOP in each street.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "oncomingTraffic", "trafficFromRight"]
#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: place = "junction"
#: control = "stop-sign"

egoRoute = selectRoute(maneuver="straight", place="junction", control="stop-sign", crossed=("right", "oncoming"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromRight = trafficFrom(egoRoute, "right")
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
