#: description = "The ego makes an unprotected left turn at a signalised intersection while oncoming traffic also has green."
#: rephrasings = [
#:   "A left turn on green without an arrow, yielding to opposing vehicles.",
#:   "The ego starts turning left across the path of oncoming cars at traffic lights.",
#:   "The car under test makes an unprotected left; those who come toward it have right of way.",
#:   "Turning left at the lights with no protected phase.",
#:   "At a crossing with signals the ego turns left in front of oncoming traffic.",
#:   "Vehicle 1 was turning left on a circular green signal across opposing traffic.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["crossSignal", "egoRoute", "egoSpawnPt", "junctionExit", "oncomingTraffic", "trafficFromLeft", "trafficFromRight"]
#: origin = "base scenario unprotected-left-turn; own code"
#: [slots]
#: maneuver = "left-turn"
#: place = "four-way"
#: control = "signal"

param signals = 'ego-green'
crossSignal = "red"
egoRoute = selectRoute(maneuver="left-turn", place="four-way", control="signal", crossed=("left", "right", "oncoming"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
trafficFromRight = trafficFrom(egoRoute, "right")
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
