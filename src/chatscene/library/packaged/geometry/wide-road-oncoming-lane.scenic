#: description = "The ego drives straight in the inner of two lanes, with the oncoming lane on its left."
#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: place = "road"
#: lanes = 2
#: two_way = true

egoRoute = selectRoute(maneuver="straight", place="road", lanes=2, opposite=True)
egoSpawnPt = startOf(egoRoute)
oppositeLane = neighbourPath(egoRoute, "left")
rightLane = neighbourPath(egoRoute, "right")
adjacentLane = rightLane
