#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: place = "road"
#: lanes = 2
#: [variants]
#: wide-road-lane-on-left  = { beside = "left" }
#: wide-road-lane-on-right = { beside = "right" }
#: [descriptions]
#: wide-road-lane-on-left  = "The ego drives straight in the right of two lanes; there is a lane of its direction to its left."
#: wide-road-lane-on-right = "The ego drives straight in the left of two lanes; there is a lane of its direction to its right."

egoRoute = selectRoute(maneuver="straight", place="road", lanes=2, beside="$beside")
egoSpawnPt = startOf(egoRoute)
adjacentLane = neighbourPath(egoRoute, "$beside")
${beside}Lane = adjacentLane
kerbLane = ownLane(egoRoute)  #: if beside left
