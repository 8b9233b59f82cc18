#: description = "The ego turns left at a three-way intersection."
#: rephrasings = [
#:   "A left turn at a T-junction.",
#:   "The ego makes a left where a side road joins.",
#:   "The car under test turns left at a junction with three arms.",
#:   "Turning left from or into the stem of a T.",
#:   "The route goes left at a fork of three streets.",
#:   "Vehicle 1 was turning left at a three-leg intersection.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit"]
#: origin = "base scenario turning-obstacle; own code"
#: [slots]
#: maneuver = "left-turn"
#: place = "three-way"

egoRoute = selectRoute(maneuver="left-turn", place="three-way")
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
