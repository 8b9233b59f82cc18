#: description = "The ego turns left at a three-way intersection with traffic lights, leaving the through road for the side road."
#: rephrasings = [
#:   "The ego makes a left at an intersection with three arms controlled by traffic lights, leaving the main road.",
#:   "Where a side street comes in, traffic lights, ours is green, we want to go left, we leave the main road for the little one.",
#:   "LT, lights 3-leg, into stem of T",
#:   "Vehicle 1 began to turn left at a three-leg intersection equipped with traffic signals from the through road into the intersecting leg.",
#:   "The VUT performs a turn to the left at a three-arm junction regulated by a traffic light, leaving the through road for the stem of the T.",
#:   "The ego car makes the turning to left side in crossing that has only three streets with lights of traffic, from the main street into the small one.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["crossSignal", "egoRoute", "egoSpawnPt", "junctionExit", "oncomingTraffic", "trafficFromLeft"]
#: origin = "own code"
#: [slots]
#: maneuver = "left-turn"
#: place = "three-way"
#: control = "signal"

param signals = 'ego-green'
crossSignal = "red"
egoRoute = selectRoute(maneuver="left-turn", place="three-way", control="signal", crossed=("left", "oncoming"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
