#: description = "The ego turns right at a four-way intersection without traffic lights."
#: rephrasings = [
#:   "A right turn at uncontrolled crossroads.",
#:   "The ego makes a right at a crossing of two streets that has no signals.",
#:   "The car under test turns right where nobody regulates the four arms.",
#:   "Turning right at an unsignalised intersection, cars may come from the left.",
#:   "An unregulated four-arm junction, the ego goes right.",
#:   "ego RT, 4-way, no control",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "oncomingTraffic", "trafficFromLeft"]
#: origin = "base scenario right-turn; own code"
#: [slots]
#: maneuver = "right-turn"
#: place = "four-way"
#: control = "none"

egoRoute = selectRoute(maneuver="right-turn", place="four-way", control="none", crossed=("left", "oncoming"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
