#: description = "The ego drives straight through a three-way intersection with traffic lights; the side road joins from the left."
#: rephrasings = [
#:   "The ego keeps straight ahead at a T-junction controlled by traffic lights, with a road joining on the left.",
#:   "Where another road joins, traffic lights, ours is green, we're going right over, no turning, there's a turning on the left that we ignore.",
#:   "straight movement, lights T-junction, minor rd on left",
#:   "Vehicle 1 intended to continue straight through a T-intersection equipped with traffic signals; the intersecting road entered from the left.",
#:   "The VUT continues in a straight line across a T-junction with three arms regulated by a traffic light, the third arm lies on the left.",
#:   "The ego car is going always straight over at the T of streets with lights of traffic, the small street comes from left hand.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["crossSignal", "egoRoute", "egoSpawnPt", "junctionExit", "trafficFromLeft"]
#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: place = "three-way"
#: control = "signal"

param signals = 'ego-green'
crossSignal = "red"
egoRoute = selectRoute(maneuver="straight", place="three-way", control="signal", crossed=("left",))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
