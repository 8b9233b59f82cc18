#: description = "The ego turns left at an intersection of any kind with stop signs."
#: rephrasings = [
#:   "The ego makes a left at a junction of whatever shape where every arm has a stop sign.",
#:   "Where the streets meet, where everyone has to stop first, we want to go left.",
#:   "LT, stop-controlled xing",
#:   "Vehicle 1 began to turn left at an intersection where all legs had stop signs.",
#:   "The VUT performs a turn to the left at a road junction controlled by STOP signs.",
#:   "The ego car makes the turning to left side in the crossing of roads where stand the stop signs.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "oncomingTraffic", "trafficFromLeft"]
#: origin = "own code"
#: [slots]
#: maneuver = "left-turn"
#: place = "junction"
#: control = "stop-sign"

egoRoute = selectRoute(maneuver="left-turn", place="junction", control="stop-sign", crossed=("left", "oncoming"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
