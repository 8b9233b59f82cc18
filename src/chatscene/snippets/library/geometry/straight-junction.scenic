#: description = "The ego drives straight through an intersection."
#: rephrasings = [
#:   "Straight on at a junction of any kind.",
#:   "The ego passes over a crossing.",
#:   "The car under test continues ahead where streets meet.",
#:   "Moving straight through the intersection.",
#:   "The ego's route leads over a junction without turning.",
#:   "Vehicle 1 was traveling straight through an intersection.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit"]
#: origin = "base scenario crossing-negotiation; own code"
#: [slots]
#: maneuver = "straight"
#: place = "junction"

egoRoute = selectRoute(maneuver="straight", place="junction")
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
