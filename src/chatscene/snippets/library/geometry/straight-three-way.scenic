#: description = "The ego drives straight past a side road at a three-way intersection."
#: rephrasings = [
#:   "Straight on at a T-junction.",
#:   "The ego passes the mouth of a joining street.",
#:   "The car under test goes along the top of a T.",
#:   "A junction with three arms, the ego keeps straight on.",
#:   "A street joins from the side while the ego continues ahead.",
#:   "ego straight, minor road joins",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit"]
#: origin = "base scenario crossing-negotiation; own code"
#: [slots]
#: maneuver = "straight"
#: place = "three-way"

egoRoute = selectRoute(maneuver="straight", place="three-way")
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
