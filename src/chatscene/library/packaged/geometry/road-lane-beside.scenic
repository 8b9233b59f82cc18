#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: place = "road"
#: lanes = 2
#: [variants]
#: straight-lane-on-left  = { beside = "left" }
#: straight-lane-on-right = { beside = "right" }
#: [descriptions]
#: straight-lane-on-left  = "The ego drives straight on a road in the right of two lanes of its direction."
#: straight-lane-on-right = "The ego drives straight on a road in the left of two lanes of its direction."

egoRoute = selectRoute(maneuver="straight", place="road", lanes=2, beside="$beside")
egoSpawnPt = startOf(egoRoute)
adjacentLane = neighbourPath(egoRoute, "$beside")
${beside}Lane = adjacentLane
