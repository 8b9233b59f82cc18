#: description = "The ego turns right at an intersection of any kind without traffic lights or signs."
#: rephrasings = [
#:   "The ego turns right at an intersection that nothing regulates.",
#:   "At the crossing, with no lights, nothing tells you who goes first, we take a right.",
#:   "ego right turn, uncontrolled intersection",
#:   "Vehicle 1 was negotiating a right-hand turn at the intersection without traffic controls.",
#:   "The test vehicle steers to the right arm at a junction of the uncontrolled type.",
#:   "The ego bends to right at the place where streets cross where no lights and no signs exist.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "trafficFromLeft"]
#: origin = "own code"
#: [slots]
#: maneuver = "right-turn"
#: place = "junction"
#: control = "none"

egoRoute = selectRoute(maneuver="right-turn", place="junction", control="none", crossed=("left",))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
