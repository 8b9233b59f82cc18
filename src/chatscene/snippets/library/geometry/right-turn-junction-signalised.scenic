#: description = "The ego turns right at an intersection of any kind with traffic lights."
#: rephrasings = [
#:   "The ego turns right at an intersection controlled by traffic lights.",
#:   "At the crossing, traffic lights, ours is green, we take a right.",
#:   "ego right turn, lights intersection",
#:   "Vehicle 1 was negotiating a right-hand turn at the intersection equipped with traffic signals.",
#:   "The test vehicle steers to the right arm at a junction regulated by a traffic light.",
#:   "The ego bends to right at the place where streets cross with lights of traffic.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["crossSignal", "egoRoute", "egoSpawnPt", "junctionExit", "trafficFromLeft"]
#: origin = "own code"
#: [slots]
#: maneuver = "right-turn"
#: place = "junction"
#: control = "signal"

param signals = 'ego-green'
crossSignal = "red"
egoRoute = selectRoute(maneuver="right-turn", place="junction", control="signal", crossed=("left",))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
