#: description = "The ego goes straight through an unsignalised intersection and must negotiate the crossing."
#: rephrasings = [
#:   "Straight on at crossroads without traffic lights, where drivers settle who goes first.",
#:   "The ego approaches an uncontrolled four-way crossing.",
#:   "The car under test enters a junction where nothing regulates the order.",
#:   "Crossing negotiation: four arms, no signals, straight ahead.",
#:   "No lights and no signs at the crossing ahead, the ego drives on straight.",
#:   "no lights, no signs, we go straight over the crossroads",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "oncomingTraffic", "trafficFromLeft", "trafficFromRight"]
#: origin = "base scenario crossing-negotiation; own code"
#: [slots]
#: maneuver = "straight"
#: place = "four-way"
#: control = "none"

egoRoute = selectRoute(maneuver="straight", place="four-way", control="none", crossed=("left", "right", "oncoming"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
trafficFromRight = trafficFrom(egoRoute, "right")
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
