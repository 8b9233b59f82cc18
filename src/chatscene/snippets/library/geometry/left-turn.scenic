#: description = "The ego turns left at an intersection."
#: rephrasings = [
#:   "A left turn at a junction of any kind.",
#:   "The ego makes a left at the crossing.",
#:   "The car under test swings left where streets meet.",
#:   "Turning to the left at the crossroads.",
#:   "The ego's route bends left through a junction.",
#:   "ego LT at junction",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit"]
#: origin = "base scenario turning-obstacle; own code"
#: [slots]
#: maneuver = "left-turn"
#: place = "junction"

egoRoute = selectRoute(maneuver="left-turn", place="junction")
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
