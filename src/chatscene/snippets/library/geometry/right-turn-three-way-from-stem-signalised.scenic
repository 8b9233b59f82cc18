#: description = "The ego turns right at a three-way intersection with traffic lights, coming from the road that ends there."
#: rephrasings = [
#:   "The ego turns right at a T-junction with signals, where its own road ends.",
#:   "Where another road joins, with the lights on green for us, we take a right, our road stops there and we join the big one.",
#:   "ego right turn, signalised T-junction, from stem of T",
#:   "Vehicle 1 was negotiating a right-hand turn at a T-intersection with an operating traffic control signal from the terminating leg onto the through road.",
#:   "The test vehicle steers to the right arm at a T-junction with three arms with signal control, starting on the stem of the T.",
#:   "The ego bends to right at the T of streets where is a semaphore, from the street which ends there.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["crossSignal", "egoRoute", "egoSpawnPt", "junctionExit", "trafficFromLeft"]
#: origin = "own code"
#: [slots]
#: maneuver = "right-turn"
#: place = "three-way"
#: control = "signal"

param signals = 'ego-green'
crossSignal = "red"
egoRoute = selectRoute(maneuver="right-turn", place="three-way", control="signal", crossed=("left",))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
