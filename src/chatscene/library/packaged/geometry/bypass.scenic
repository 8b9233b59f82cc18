#: description = "The ego must use the opposite lane to go around a vehicle parked in its lane."
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: maneuver = "bypass"
#: place = "road"
#: lanes = 1
#: two_way = true

egoRoute = selectRoute(maneuver="bypass", place="road", opposite=True)
egoSpawnPt = startOf(egoRoute)
oppositeLane = neighbourPath(egoRoute, "left")
blockedLane = ownLane(egoRoute)
