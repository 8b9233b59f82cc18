#: description = "The ego goes straight through a four-way intersection with stop signs."
#: rephrasings = [
#:   "Straight on at an all-way stop.",
#:   "The ego approaches crossroads where every arm has a stop sign.",
#:   "The car under test crosses a junction regulated by stop signs.",
#:   "A four-way stop; the ego continues ahead.",
#:   "Stop signs stand at the crossing the ego passes.",
#:   "Vehicle 1 proceeded straight from an all-way stop.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "oncomingTraffic", "trafficFromLeft", "trafficFromRight"]
#: origin = "base scenario crossing-negotiation; own code"
#: [slots]
#: maneuver = "straight"
#: place = "four-way"
#: control = "stop-sign"

egoRoute = selectRoute(maneuver="straight", place="four-way", control="stop-sign", crossed=("left", "right", "oncoming"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
trafficFromRight = trafficFrom(egoRoute, "right")
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
