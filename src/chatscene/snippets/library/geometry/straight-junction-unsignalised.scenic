#: description = "The ego drives straight through an intersection of any kind without traffic lights or signs."
#: rephrasings = [
#:   "The ego goes straight on at an intersection that nothing regulates.",
#:   "At the crossing, with no lights, nothing tells you who goes first, we just carry on straight.",
#:   "ego straight through, uncontrolled intersection",
#:   "Vehicle 1 was proceeding straight through the intersection without traffic controls.",
#:   "The test vehicle passes without turning through a junction of the uncontrolled type.",
#:   "The ego drives direct across at the place where streets cross where no lights and no signs exist.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "oncomingTraffic", "trafficFromRight"]
#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: place = "junction"
#: control = "none"

egoRoute = selectRoute(maneuver="straight", place="junction", control="none", crossed=("right", "oncoming"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromRight = trafficFrom(egoRoute, "right")
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
