#: description = "The ego drives straight in the inner of two lanes, with the oncoming lane on its left."
#: rephrasings = [
#:   "A four-lane street without a median, two lanes each way; the ego keeps beside the centre line.",
#:   "we're in the fast lane, cars coming at us right on the other side of the yellow line",
#:   "undivided 4-lane, ego in lane 2, opposing traffic left, same-way lane right",
#:   "Vehicle 1 was traveling in the inside lane of a four-lane undivided roadway.",
#:   "The VUT drives in the lane adjacent to the opposing direction on a road with two lanes per direction.",
#:   "The ego car takes the left lane, on the left of it come the opposite vehicles, on the right is one more lane.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["adjacentLane", "egoRoute", "egoSpawnPt", "oppositeLane", "rightLane"]
#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: place = "road"
#: lanes = 2
#: two_way = true

egoRoute = selectRoute(maneuver="straight", place="road", lanes=2, opposite=True)
egoSpawnPt = startOf(egoRoute)
oppositeLane = neighbourPath(egoRoute, "left")
rightLane = neighbourPath(egoRoute, "right")
adjacentLane = rightLane
