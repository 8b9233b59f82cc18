#: description = "The ego turns right at a three-way intersection."
#: rephrasings = [
#:   "A right turn at a T-junction.",
#:   "The ego makes a right where a side road joins.",
#:   "The car under test turns right at a junction with three arms.",
#:   "Turning right from or into the stem of a T.",
#:   "The route goes right at a fork of three streets.",
#:   "we turn off to the right at a T",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit"]
#: origin = "base scenario right-turn; own code"
#: [slots]
#: maneuver = "right-turn"
#: place = "three-way"

egoRoute = selectRoute(maneuver="right-turn", place="three-way")
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
