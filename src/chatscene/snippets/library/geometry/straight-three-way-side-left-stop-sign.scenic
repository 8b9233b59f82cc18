#: description = "The ego drives straight through a three-way intersection with stop signs; the side road joins from the left."
#: rephrasings = [
#:   "The ego keeps straight ahead at an intersection with three arms with stop signs, with a road joining on the left.",
#:   "Where a side street comes in, an all-way stop, we're going right over, no turning, there's a turning on the left that we ignore.",
#:   "straight movement, AWSC 3-leg, minor rd on left",
#:   "Vehicle 1 intended to continue straight through a three-leg intersection governed by stop signs; the intersecting road entered from the left.",
#:   "The VUT continues in a straight line across a three-arm junction with STOP signs on every approach, the third arm lies on the left.",
#:   "The ego car is going always straight over in crossing that has only three streets with table STOP in each street, the small street comes from left hand.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "trafficFromLeft"]
#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: place = "three-way"
#: control = "stop-sign"

egoRoute = selectRoute(maneuver="straight", place="three-way", control="stop-sign", crossed=("left",))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
