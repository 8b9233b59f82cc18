#: description = "The ego goes around a vehicle parked in its lane through the second lane of its own direction, and comes back."
#: origin = "own code"
#: [slots]
#: maneuver = "bypass"
#: place = "road"
#: lanes = 2
#: two_way = false

egoRoute = selectRoute(maneuver="bypass", place="road", lanes=2, opposite=False)
egoSpawnPt = startOf(egoRoute)
leftLane = neighbourPath(egoRoute, "left")
adjacentLane = leftLane
blockedLane = ownLane(egoRoute)
