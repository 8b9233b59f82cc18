#: description = "The ego approaches an intersection in the right of two lanes and drives straight through."
#: rephrasings = [
#:   "On a multi-lane approach the ego keeps the outer lane and crosses the intersection.",
#:   "two lanes up to the junction, we're in the right-hand one going straight ahead",
#:   "2-lane approach, ego in lane 1 (right), straight thru junction",
#:   "Vehicle 1 was in the curb lane of a two-lane approach, continuing straight through the intersection.",
#:   "The VUT approaches the junction in the nearside lane, another lane of the same direction to its left.",
#:   "Before the crossing there are two lanes, the ego is in the right and goes direct.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["adjacentLane", "egoRoute", "egoSpawnPt", "junctionExit", "leftLane", "oncomingTraffic"]
#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: place = "junction"
#: lanes = 2

egoRoute = selectRoute(maneuver="straight", place="junction", lanes=2, beside="left", crossed=("oncoming",))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
adjacentLane = neighbourPath(egoRoute, "left")
leftLane = adjacentLane
oncomingTraffic = trafficFrom(egoRoute, "oncoming")
