#: description = "The ego turns left at an intersection of any kind without traffic lights or signs."
#: rephrasings = [
#:   "The ego turns left at an intersection that nothing regulates.",
#:   "At the crossing, with no lights, nothing tells you who goes first, we hang a left.",
#:   "ego left turn, uncontrolled intersection",
#:   "Vehicle 1 was executing a left turn at the intersection without traffic controls.",
#:   "The test vehicle steers to the left arm at a junction of the uncontrolled type.",
#:   "The ego bends to left at the place where streets cross where no lights and no signs exist.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "oncomingTraffic", "trafficFromLeft"]
#: origin = "own code"
#: [slots]
#: maneuver = "left-turn"
#: place = "junction"
#: control = "none"

egoRoute = selectRoute(maneuver="left-turn", place="junction", control="none", crossed=("left", "oncoming"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
