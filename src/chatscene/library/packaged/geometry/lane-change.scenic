#: origin = "base scenario lane-changing; own code"
#: [slots]
#: place = "road"
#: lanes = 2
#: [variants]
#: lane-change-left                = { maneuver = "lane-change-left", target = "left" }
#: lane-change-right               = { maneuver = "lane-change-right", target = "right" }
#: lane-change-right-from-oncoming = { maneuver = "lane-change-right", target = "right", two_way = true, origin = "own code" }
#: [descriptions]
#: lane-change-left                = "The ego changes to the left lane."
#: lane-change-right               = "The ego changes to the right lane."
#: lane-change-right-from-oncoming = "The ego changes to the right lane, away from the oncoming lane beside it."

egoRoute = selectRoute(maneuver="$maneuver", lanes=2)  #: unless two_way
egoRoute = selectRoute(maneuver="$maneuver", lanes=2, opposite=True)  #: if two_way
egoSpawnPt = startOf(egoRoute)
adjacentLane = neighbourPath(egoRoute, "$target")
${target}Lane = adjacentLane
oppositeLane = neighbourPath(egoRoute, "left")  #: if two_way
