#: description = "The ego drives straight on a road with several lanes in its direction."
#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: place = "road"
#: lanes = 2

egoRoute = selectRoute(maneuver="straight", place="road", lanes=2)
egoSpawnPt = startOf(egoRoute)
adjacentLane = adjacentPath(egoRoute)
