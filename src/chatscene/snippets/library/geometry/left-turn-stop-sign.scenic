#: description = "The ego turns left at a four-way intersection with stop signs."
#: rephrasings = [
#:   "The ego turns left at crossroads with four arms where every arm has a stop sign.",
#:   "At the crossroads, where everyone has to stop first, we hang a left.",
#:   "ego left turn, stop-controlled four-leg",
#:   "Vehicle 1 was executing a left turn at a four-leg intersection where all legs had stop signs.",
#:   "The test vehicle steers to the left arm at a four-arm junction controlled by STOP signs.",
#:   "The ego bends to left in crossing with four streets where stand the stop signs.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "oncomingTraffic", "trafficFromLeft", "trafficFromRight"]
#: origin = "own code"
#: [slots]
#: maneuver = "left-turn"
#: place = "four-way"
#: control = "stop-sign"

egoRoute = selectRoute(maneuver="left-turn", place="four-way", control="stop-sign", crossed=("left", "right", "oncoming"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
trafficFromRight = trafficFrom(egoRoute, "right")
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
