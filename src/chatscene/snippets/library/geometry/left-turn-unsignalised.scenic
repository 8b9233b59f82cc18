#: description = "The ego turns left at a four-way intersection without traffic lights."
#: rephrasings = [
#:   "A left turn at uncontrolled crossroads.",
#:   "The ego makes a left at a crossing of two streets that has no signals.",
#:   "The car under test turns left where nobody regulates the four arms.",
#:   "Turning left at an unsignalised intersection, cross traffic may come.",
#:   "An unregulated four-arm junction, the ego goes left.",
#:   "we're hanging a left where there are no lights",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "oncomingTraffic", "trafficFromLeft", "trafficFromRight"]
#: origin = "base scenario turning-obstacle; own code"
#: [slots]
#: maneuver = "left-turn"
#: place = "four-way"
#: control = "none"

egoRoute = selectRoute(maneuver="left-turn", place="four-way", control="none", crossed=("left", "right", "oncoming"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
trafficFromRight = trafficFrom(egoRoute, "right")
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
