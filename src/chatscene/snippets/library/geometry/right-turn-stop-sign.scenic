#: description = "The ego turns right at a four-way intersection with stop signs."
#: rephrasings = [
#:   "The ego makes a right at crossroads with four arms where every arm has a stop sign.",
#:   "At the crossroads, where everyone has to stop first, we're nipping off to the right.",
#:   "RT, stop-controlled four-leg",
#:   "Vehicle 1 began to turn right at a four-leg intersection where all legs had stop signs.",
#:   "The VUT performs a turn to the right at a four-arm junction controlled by STOP signs.",
#:   "The ego car makes the turning to right side in crossing with four streets where stand the stop signs.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "oncomingTraffic", "trafficFromLeft"]
#: origin = "own code"
#: [slots]
#: maneuver = "right-turn"
#: place = "four-way"
#: control = "stop-sign"

egoRoute = selectRoute(maneuver="right-turn", place="four-way", control="stop-sign", crossed=("left", "oncoming"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
