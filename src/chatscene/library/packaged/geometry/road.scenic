#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: [variants]
#: straight-road    = { place = "road", origin = "base scenario straight-obstacle; own code" }
#: curve            = { place = "curve" }
#: straight-two-way = { place = "road", lanes = 1, two_way = true }
#: curve-two-way    = { place = "curve", lanes = 1, two_way = true }
#: left-curve       = { place = "left-curve", lanes = 1, two_way = true }
#: right-curve      = { place = "right-curve", lanes = 1, two_way = true }
#: [descriptions]
#: straight-road    = "The ego vehicle drives on a straight road."
#: curve            = "The ego drives around a curve of the road."
#: straight-two-way = "The ego drives straight on a narrow two-way road with one lane in each direction."
#: curve-two-way    = "The ego follows a bend of a narrow two-way road, an oncoming lane beside it."
#: left-curve       = "The ego follows a two-way road that bends to the left."
#: right-curve      = "The ego follows a two-way road that bends to the right."

egoRoute = selectRoute(maneuver="straight", place="$place")  #: unless two_way
egoRoute = selectRoute(maneuver="straight", place="$place", opposite=True, beside="none")  #: if two_way
egoSpawnPt = startOf(egoRoute)
oppositeLane = neighbourPath(egoRoute, "left")  #: if two_way
kerbLane = ownLane(egoRoute)
