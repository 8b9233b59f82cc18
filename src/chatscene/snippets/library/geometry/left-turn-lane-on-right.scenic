#: description = "The ego turns left at an intersection from the left of two lanes."
#: rephrasings = [
#:   "From the inner lane of a wide approach the ego makes a left at the junction.",
#:   "we're in the left-turn lane with another lane on our right, and swing left",
#:   "left turn from lane 2, through lane to the right",
#:   "Vehicle 1 was turning left from the innermost of two approach lanes.",
#:   "The VUT performs a turn to the left from the offside lane of a two-lane approach.",
#:   "The ego stays in left of the two lanes and turns to left in the crossing.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["adjacentLane", "egoRoute", "egoSpawnPt", "junctionExit", "rightLane", "trafficFromLeft", "trafficFromRight"]
#: origin = "own code"
#: [slots]
#: maneuver = "left-turn"
#: place = "junction"
#: lanes = 2

egoRoute = selectRoute(maneuver="left-turn", place="junction", lanes=2, beside="right", crossed=("left", "right"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
adjacentLane = neighbourPath(egoRoute, "right")
rightLane = adjacentLane
trafficFromLeft = trafficFrom(egoRoute, "left")
trafficFromRight = trafficFrom(egoRoute, "right")
