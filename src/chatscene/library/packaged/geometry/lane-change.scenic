#: origin = "base scenario lane-changing; own code"
#: [slots]
#: place = "road"
#: [variants]
#: lane-change-left                = { maneuver = "lane-change-left", target = "left", lanes = 2 }
#: lane-change-left-into-oncoming  = { maneuver = "lane-change-left", lanes = 1, two_way = true, origin = "Euro NCAP CCFhol: the ego drifts into the lane of oncoming traffic" }
#: lane-change-right               = { maneuver = "lane-change-right", target = "right", lanes = 2 }
#: lane-change-right-from-oncoming = { maneuver = "lane-change-right", target = "right", lanes = 2, two_way = true, origin = "own code" }
#: [descriptions]
#: lane-change-left-into-oncoming  = "The ego changes to the left, into the lane of oncoming traffic."
#: lane-change-left                = "The ego changes to the left lane."
#: lane-change-right               = "The ego changes to the right lane."
#: lane-change-right-from-oncoming = "The ego changes to the right lane, away from the oncoming lane beside it."

egoRoute = selectRoute(maneuver="$maneuver", lanes=2)  #: unless two_way
egoRoute = selectRoute(maneuver="$maneuver", lanes=$lanes, opposite=True)  #: if two_way
egoSpawnPt = startOf(egoRoute)
laneLeft = leftAt(egoRoute)
adjacentLane = neighbourPath(egoRoute, "$target")  #: if target
${target}Lane = adjacentLane  #: if target
oppositeLane = neighbourPath(egoRoute, "left")  #: if two_way
