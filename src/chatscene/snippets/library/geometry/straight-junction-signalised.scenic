#: description = "The ego drives straight through an intersection of any kind with traffic lights."
#: rephrasings = [
#:   "The ego keeps straight ahead at an intersection controlled by traffic lights.",
#:   "At the crossing, traffic lights, ours is green, we're going right over, no turning.",
#:   "straight movement, lights intersection",
#:   "Vehicle 1 intended to continue straight through the intersection equipped with traffic signals.",
#:   "The VUT continues in a straight line across a junction regulated by a traffic light.",
#:   "The ego car is going always straight over at the place where streets cross with lights of traffic.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["crossSignal", "egoRoute", "egoSpawnPt", "junctionExit", "oncomingTraffic", "trafficFromRight"]
#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: place = "junction"
#: control = "signal"

param signals = 'ego-green'
crossSignal = "red"
egoRoute = selectRoute(maneuver="straight", place="junction", control="signal", crossed=("right", "oncoming"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromRight = trafficFrom(egoRoute, "right")
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
