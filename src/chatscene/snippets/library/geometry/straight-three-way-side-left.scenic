#: description = "The ego drives straight through a three-way intersection; the side road joins from the left."
#: rephrasings = [
#:   "The ego keeps straight ahead at a T-junction, with a road joining on the left.",
#:   "Where another road joins, we're going right over, no turning, there's a turning on the left that we ignore.",
#:   "straight movement, T-junction, minor rd on left",
#:   "Vehicle 1 intended to continue straight through a T-intersection; the intersecting road entered from the left.",
#:   "The VUT continues in a straight line across a T-junction with three arms, the third arm lies on the left.",
#:   "The ego car is going always straight over at the T of streets, the small street comes from left hand.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "trafficFromLeft"]
#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: place = "three-way"

egoRoute = selectRoute(maneuver="straight", place="three-way", crossed=("left",))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
