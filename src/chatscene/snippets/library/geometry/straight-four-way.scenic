#: description = "The ego drives straight through a four-way intersection."
#: rephrasings = [
#:   "The ego keeps straight ahead at a four-way crossing.",
#:   "Where two streets cross, we're going right over, no turning.",
#:   "straight movement, 4-way",
#:   "Vehicle 1 intended to continue straight through a cross intersection.",
#:   "The VUT continues in a straight line across a junction with four arms.",
#:   "The ego car is going always straight over at the cross of two streets.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "oncomingTraffic", "trafficFromLeft", "trafficFromRight"]
#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: place = "four-way"

egoRoute = selectRoute(maneuver="straight", place="four-way", crossed=("left", "right", "oncoming"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
trafficFromRight = trafficFrom(egoRoute, "right")
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
