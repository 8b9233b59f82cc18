#: description = "The ego changes to the right lane, away from the oncoming lane beside it."
#: rephrasings = [
#:   "On an undivided road with two lanes per direction the ego moves from the inner to the outer lane.",
#:   "we move back over to the right, away from the cars coming the other way",
#:   "lane change right, 4-lane undivided, opposing lane on the left",
#:   "Vehicle 1 was changing lanes to the right, departing the lane next to the centerline.",
#:   "The VUT performs a lane change from the lane adjacent to opposing traffic into the nearside lane.",
#:   "The ego car leaves the lane in the middle of the street and goes into the right one.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["adjacentLane", "egoRoute", "egoSpawnPt", "oppositeLane", "rightLane"]
#: origin = "own code"
#: [slots]
#: maneuver = "lane-change-right"
#: place = "road"
#: lanes = 2
#: two_way = true

egoRoute = selectRoute(maneuver="lane-change-right", lanes=2, opposite=True)
egoSpawnPt = startOf(egoRoute)
adjacentLane = neighbourPath(egoRoute, "right")
rightLane = adjacentLane
oppositeLane = neighbourPath(egoRoute, "left")
