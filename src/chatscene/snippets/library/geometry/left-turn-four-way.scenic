#: description = "The ego turns left at a four-way intersection."
#: rephrasings = [
#:   "The ego turns left at crossroads with four arms.",
#:   "At the crossroads, we hang a left.",
#:   "ego left turn, four-leg",
#:   "Vehicle 1 was executing a left turn at a four-leg intersection.",
#:   "The test vehicle steers to the left arm at a four-arm junction.",
#:   "The ego bends to left in crossing with four streets.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "oncomingTraffic", "trafficFromLeft", "trafficFromRight"]
#: origin = "own code"
#: [slots]
#: maneuver = "left-turn"
#: place = "four-way"

egoRoute = selectRoute(maneuver="left-turn", place="four-way", crossed=("left", "right", "oncoming"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
trafficFromRight = trafficFrom(egoRoute, "right")
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
