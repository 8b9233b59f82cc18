#: description = "The ego approaches an intersection in the left of two lanes and drives straight through."
#: rephrasings = [
#:   "On a multi-lane approach the ego keeps the inner lane and crosses the intersection.",
#:   "two lanes up to the junction, we're in the left-hand one going straight ahead",
#:   "2-lane approach, ego in lane 2 (left), straight thru junction",
#:   "Vehicle 1 was in the inside lane of a two-lane approach, continuing straight through the intersection.",
#:   "The VUT approaches the junction in the offside lane, another lane of the same direction to its right.",
#:   "Before the crossing there are two lanes, the ego is in the left and goes direct.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["adjacentLane", "egoRoute", "egoSpawnPt", "junctionExit", "rightLane", "trafficFromLeft", "trafficFromRight"]
#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: place = "junction"
#: lanes = 2

egoRoute = selectRoute(maneuver="straight", place="junction", lanes=2, beside="right", crossed=("left", "right"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
adjacentLane = neighbourPath(egoRoute, "right")
rightLane = adjacentLane
trafficFromLeft = trafficFrom(egoRoute, "left")
trafficFromRight = trafficFrom(egoRoute, "right")
