#: description = "The ego turns right at a three-way intersection with traffic lights, leaving the through road for the side road."
#: rephrasings = [
#:   "The ego makes a right at a T-junction controlled by traffic lights, leaving the main road.",
#:   "Where another road joins, traffic lights, ours is green, we're nipping off to the right, we leave the main road for the little one.",
#:   "RT, lights T-junction, into stem of T",
#:   "Vehicle 1 began to turn right at a T-intersection equipped with traffic signals from the through road into the intersecting leg.",
#:   "The VUT performs a turn to the right at a T-junction with three arms regulated by a traffic light, leaving the through road for the stem of the T.",
#:   "The ego car makes the turning to right side at the T of streets with lights of traffic, from the main street into the small one.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["crossSignal", "egoRoute", "egoSpawnPt", "junctionExit", "oncomingTraffic"]
#: origin = "own code"
#: [slots]
#: maneuver = "right-turn"
#: place = "three-way"
#: control = "signal"

param signals = 'ego-green'
crossSignal = "red"
egoRoute = selectRoute(maneuver="right-turn", place="three-way", control="signal", crossed=("oncoming",))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
