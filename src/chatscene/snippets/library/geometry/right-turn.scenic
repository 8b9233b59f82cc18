#: description = "The ego turns right at an intersection."
#: rephrasings = [
#:   "A right turn at a junction of any kind.",
#:   "The ego makes a right at the crossing.",
#:   "The car under test swings right where streets meet.",
#:   "Turning to the right at the crossroads.",
#:   "The ego's route bends right through a junction.",
#:   "The VUT performs a turn to the nearside at a junction.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "trafficFromLeft"]
#: origin = "base scenario right-turn; own code"
#: [slots]
#: maneuver = "right-turn"
#: place = "junction"

egoRoute = selectRoute(maneuver="right-turn", place="junction", crossed=("left",))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
