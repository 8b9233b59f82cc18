#: description = "The ego drives straight through a three-way intersection with traffic lights; the side road joins from the right."
#: rephrasings = [
#:   "The ego keeps straight ahead at a T-junction with signals, with a road joining on the right.",
#:   "Where another road joins, with the lights on green for us, we're going right over, no turning, there's a turning on the right that we ignore.",
#:   "straight movement, signalised T-junction, minor rd on right",
#:   "Vehicle 1 intended to continue straight through a T-intersection with an operating traffic control signal; the intersecting road entered from the right.",
#:   "The VUT continues in a straight line across a T-junction with three arms with signal control, the third arm lies on the right.",
#:   "The ego car is going always straight over at the T of streets where is a semaphore, the small street comes from right hand.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["crossSignal", "egoRoute", "egoSpawnPt", "junctionExit", "oncomingTraffic", "trafficFromRight"]
#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: place = "three-way"
#: control = "signal"

param signals = 'ego-green'
crossSignal = "red"
egoRoute = selectRoute(maneuver="straight", place="three-way", control="signal", crossed=("right", "oncoming"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromRight = trafficFrom(egoRoute, "right")
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
