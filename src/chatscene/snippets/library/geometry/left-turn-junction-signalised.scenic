#: description = "The ego turns left at an intersection of any kind with traffic lights."
#: rephrasings = [
#:   "The ego turns left at a junction of whatever shape controlled by traffic lights.",
#:   "Where the streets meet, traffic lights, ours is green, we hang a left.",
#:   "ego left turn, lights xing",
#:   "Vehicle 1 was executing a left turn at an intersection equipped with traffic signals.",
#:   "The test vehicle steers to the left arm at a road junction regulated by a traffic light.",
#:   "The ego bends to left in the crossing of roads with lights of traffic.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["crossSignal", "egoRoute", "egoSpawnPt", "junctionExit", "oncomingTraffic", "trafficFromLeft"]
#: origin = "own code"
#: [slots]
#: maneuver = "left-turn"
#: place = "junction"
#: control = "signal"

param signals = 'ego-green'
crossSignal = "red"
egoRoute = selectRoute(maneuver="left-turn", place="junction", control="signal", crossed=("left", "oncoming"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
