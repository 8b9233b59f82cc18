#: description = "The ego drives straight through a signalised intersection on green while crossing traffic has red."
#: rephrasings = [
#:   "Straight on at traffic lights; the cross street must wait.",
#:   "The ego passes a crossing with signals, its own light green.",
#:   "The car under test goes straight over a junction where the other axis has a red light.",
#:   "Moving straight ahead through crossroads regulated by lights.",
#:   "Green for the ego, red for those who come from the sides.",
#:   "we've got green and go straight over",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["crossSignal", "egoRoute", "egoSpawnPt", "junctionExit", "oncomingTraffic", "trafficFromLeft", "trafficFromRight"]
#: origin = "base scenario red-light-running; own code"
#: [slots]
#: maneuver = "straight"
#: place = "four-way"
#: control = "signal"

param signals = 'ego-green'
crossSignal = "red"
egoRoute = selectRoute(maneuver="straight", place="four-way", control="signal", crossed=("left", "right", "oncoming"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
trafficFromRight = trafficFrom(egoRoute, "right")
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
