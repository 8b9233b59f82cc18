#: description = "The ego turns right at a four-way intersection."
#: rephrasings = [
#:   "The ego makes a right at crossroads with four arms.",
#:   "At the crossroads, we're nipping off to the right.",
#:   "RT, four-leg",
#:   "Vehicle 1 began to turn right at a four-leg intersection.",
#:   "The VUT performs a turn to the right at a four-arm junction.",
#:   "The ego car makes the turning to right side in crossing with four streets.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "oncomingTraffic", "trafficFromLeft"]
#: origin = "own code"
#: [slots]
#: maneuver = "right-turn"
#: place = "four-way"

egoRoute = selectRoute(maneuver="right-turn", place="four-way", crossed=("left", "oncoming"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
