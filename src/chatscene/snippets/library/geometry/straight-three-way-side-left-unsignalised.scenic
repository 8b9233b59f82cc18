#: description = "The ego drives straight through a three-way intersection without traffic lights or signs; the side road joins from the left."
#: rephrasings = [
#:   "The ego goes straight on at an intersection with three arms that nothing regulates, with a road joining on the left.",
#:   "Where a side street comes in, with no lights, nothing tells you who goes first, we just carry on straight, there's a turning on the left that we ignore.",
#:   "ego straight through, uncontrolled 3-leg, minor rd on left",
#:   "Vehicle 1 was proceeding straight through a three-leg intersection without traffic controls; the intersecting road entered from the left.",
#:   "The test vehicle passes without turning through a three-arm junction of the uncontrolled type, the third arm lies on the left.",
#:   "The ego drives direct across in crossing that has only three streets where no lights and no signs exist, the small street comes from left hand.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "trafficFromLeft"]
#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: place = "three-way"
#: control = "none"

egoRoute = selectRoute(maneuver="straight", place="three-way", control="none", crossed=("left",))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
