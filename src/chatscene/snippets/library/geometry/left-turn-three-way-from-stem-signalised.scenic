#: description = "The ego turns left at a three-way intersection with traffic lights, coming from the road that ends there."
#: rephrasings = [
#:   "The ego turns left at an intersection with three arms with signals, where its own road ends.",
#:   "Where a side street comes in, with the lights on green for us, we hang a left, our road stops there and we join the big one.",
#:   "ego left turn, signalised 3-leg, from stem of T",
#:   "Vehicle 1 was executing a left turn at a three-leg intersection with an operating traffic control signal from the terminating leg onto the through road.",
#:   "The test vehicle steers to the left arm at a three-arm junction with signal control, starting on the stem of the T.",
#:   "The ego bends to left in crossing that has only three streets where is a semaphore, from the street which ends there.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["crossSignal", "egoRoute", "egoSpawnPt", "junctionExit", "trafficFromLeft", "trafficFromRight"]
#: origin = "own code"
#: [slots]
#: maneuver = "left-turn"
#: place = "three-way"
#: control = "signal"

param signals = 'ego-green'
crossSignal = "red"
egoRoute = selectRoute(maneuver="left-turn", place="three-way", control="signal", crossed=("left", "right"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
trafficFromRight = trafficFrom(egoRoute, "right")
