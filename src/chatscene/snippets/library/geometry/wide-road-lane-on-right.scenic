#: description = "The ego drives straight in the left of two lanes; there is a lane of its direction to its right."
#: rephrasings = [
#:   "The ego keeps to the inner lane of a road with several lanes, with room for others on its right.",
#:   "Straight ahead on a multi-lane street, the neighbouring lane lies on the right.",
#:   "The ego cruises in the fast lane; slower traffic may use the lane to the right.",
#:   "A wide road where a parallel lane runs along the right side of the ego.",
#:   "No lane change: the ego stays left and another lane goes the same way on its right.",
#:   "we're in the left-hand of two lanes, somebody else can be on our right",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["adjacentLane", "egoRoute", "egoSpawnPt", "rightLane"]
#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: place = "road"
#: lanes = 2

egoRoute = selectRoute(maneuver="straight", place="road", lanes=2, beside="right")
egoSpawnPt = startOf(egoRoute)
adjacentLane = neighbourPath(egoRoute, "right")
rightLane = adjacentLane
