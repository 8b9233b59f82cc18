#: description = "The ego drives straight through a three-way intersection without traffic lights or signs; the side road joins from the right."
#: rephrasings = [
#:   "The ego keeps straight ahead at an intersection with three arms without any signals or signs, with a road joining on the right.",
#:   "Where a side street comes in, no signs, no signals, everybody just sorts it out, we're going right over, no turning, there's a turning on the right that we ignore.",
#:   "straight movement, no TCD 3-leg, minor rd on right",
#:   "Vehicle 1 intended to continue straight through a three-leg intersection with no traffic control device; the intersecting road entered from the right.",
#:   "The VUT continues in a straight line across a three-arm junction without signal or sign control, the third arm lies on the right.",
#:   "The ego car is going always straight over in crossing that has only three streets without any light or table, the small street comes from right hand.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "junctionExit", "oncomingTraffic", "trafficFromRight"]
#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: place = "three-way"
#: control = "none"

egoRoute = selectRoute(maneuver="straight", place="three-way", control="none", crossed=("right", "oncoming"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromRight = trafficFrom(egoRoute, "right")
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
