#: description = "The ego changes to the left lane."
#: rephrasings = [
#:   "The ego moves over into the lane on its left.",
#:   "A lane change to the left on a road with parallel lanes.",
#:   "The car under test pulls out to the left to evade a slow vehicle.",
#:   "The ego leaves its lane for the neighbouring one on the left-hand side.",
#:   "Attempting to switch lanes, the ego steers left.",
#:   "ego lane change L, parallel lanes",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["adjacentLane", "egoRoute", "egoSpawnPt", "leftLane"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: maneuver = "lane-change-left"
#: place = "road"
#: lanes = 2

egoRoute = selectRoute(maneuver="lane-change-left", lanes=2)
egoSpawnPt = startOf(egoRoute)
adjacentLane = neighbourPath(egoRoute, "left")
leftLane = adjacentLane
