#: description = "The ego turns right at a four-way intersection with traffic lights."
#: rephrasings = [
#:   "A right turn on green at signals.",
#:   "The ego makes a right at a crossing that lights regulate.",
#:   "The car under test turns right where a traffic signal stands.",
#:   "Turning right at signalised crossroads while cross traffic has red.",
#:   "With its light green, the ego goes right.",
#:   "Vehicle 1 was turning right on a green signal.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["crossSignal", "egoRoute", "egoSpawnPt", "junctionExit", "oncomingTraffic", "trafficFromLeft"]
#: origin = "base scenario right-turn; own code"
#: [slots]
#: maneuver = "right-turn"
#: place = "four-way"
#: control = "signal"

param signals = 'ego-green'
crossSignal = "red"
egoRoute = selectRoute(maneuver="right-turn", place="four-way", control="signal", crossed=("left", "oncoming"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
