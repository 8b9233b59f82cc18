#: description = "The ego changes to the right lane."
#: rephrasings = [
#:   "The ego moves over into the lane on its right.",
#:   "A lane change to the right on a road with parallel lanes.",
#:   "The car under test pulls out to the right to evade a slow vehicle.",
#:   "The ego leaves its lane for the neighbouring one on the right-hand side.",
#:   "Attempting to switch lanes, the ego steers right.",
#:   "ego lane change R, parallel lanes",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["adjacentLane", "egoRoute", "egoSpawnPt", "rightLane"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: maneuver = "lane-change-right"
#: place = "road"
#: lanes = 2

egoRoute = selectRoute(maneuver="lane-change-right", lanes=2)
egoSpawnPt = startOf(egoRoute)
adjacentLane = neighbourPath(egoRoute, "right")
rightLane = adjacentLane
