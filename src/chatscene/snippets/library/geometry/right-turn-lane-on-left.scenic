#: description = "The ego turns right at an intersection from the right of two lanes."
#: rephrasings = [
#:   "From the outer lane of a wide approach the ego makes a right at the junction.",
#:   "we keep to the right-hand lane of two and turn off to the right",
#:   "right turn from lane 1, second lane to the left",
#:   "Vehicle 1 was turning right from the curb lane; an adjacent lane carried traffic in the same direction.",
#:   "The VUT performs a turn to the right from the nearside lane of a two-lane approach.",
#:   "The ego stays in right of the two lanes and turns to right in the crossing.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["adjacentLane", "egoRoute", "egoSpawnPt", "junctionExit", "leftLane", "trafficFromLeft"]
#: origin = "own code"
#: [slots]
#: maneuver = "right-turn"
#: place = "junction"
#: lanes = 2

egoRoute = selectRoute(maneuver="right-turn", place="junction", lanes=2, beside="left", crossed=("left",))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
adjacentLane = neighbourPath(egoRoute, "left")
leftLane = adjacentLane
trafficFromLeft = trafficFrom(egoRoute, "left")
