#: description = "The ego drives straight in the right of two lanes; there is a lane of its direction to its left."
#: rephrasings = [
#:   "The ego keeps to the outer lane of a road with several lanes, with room for others on its left.",
#:   "Straight ahead on a multi-lane street, the neighbouring lane lies on the left.",
#:   "The ego cruises in the slow lane; faster traffic may overtake in the lane to the left.",
#:   "A wide road where a parallel lane runs along the left side of the ego.",
#:   "No lane change: the ego stays right and another lane goes the same way on its left.",
#:   "Vehicle 1 was in the right lane of two same-direction lanes.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["adjacentLane", "egoRoute", "egoSpawnPt", "kerbLane", "leftLane"]
#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: place = "road"
#: lanes = 2

egoRoute = selectRoute(maneuver="straight", place="road", lanes=2, beside="left")
egoSpawnPt = startOf(egoRoute)
adjacentLane = neighbourPath(egoRoute, "left")
leftLane = adjacentLane
kerbLane = ownLane(egoRoute)
