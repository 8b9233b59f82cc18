#: description = "The ego turns right at an intersection of any kind with stop signs."
#: rephrasings = [
#:   "The ego makes a right at an intersection with stop signs.",
#:   "At the crossing, an all-way stop, we're nipping off to the right.",
#:   "RT, AWSC intersection",
#:   "Vehicle 1 began to turn right at the intersection governed by stop signs.",
#:   "The VUT performs a turn to the right at a junction with STOP signs on every approach.",
#:   "The ego car makes the turning to right side at the place where streets cross with table STOP in each street.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "trafficFromLeft"]
#: origin = "own code"
#: [slots]
#: maneuver = "right-turn"
#: place = "junction"
#: control = "stop-sign"

egoRoute = selectRoute(maneuver="right-turn", place="junction", control="stop-sign", crossed=("left",))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
