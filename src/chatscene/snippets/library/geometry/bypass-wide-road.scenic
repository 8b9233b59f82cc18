#: description = "The ego goes around a vehicle parked in its lane through the second lane of its own direction, and comes back."
#: rephrasings = [
#:   "On a road with two lanes per direction the ego passes a standing car on the left and returns to its lane.",
#:   "somebody's parked in our lane, so we nip out into the other lane and back in again",
#:   "stopped veh in right lane, ego passes via left lane, multi-lane",
#:   "Vehicle 1 was steering around a disabled vehicle in lane 1, using lane 2.",
#:   "The VUT avoids a stationary target by the adjacent lane of the same direction and then moves back.",
#:   "The lane of the ego is closed by a stopped vehicle, it drives around by the lane left of it, no opposite traffic there.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["adjacentLane", "blockedLane", "egoRoute", "egoSpawnPt", "leftLane"]
#: origin = "own code"
#: [slots]
#: maneuver = "bypass"
#: place = "road"
#: lanes = 2
#: two_way = false

egoRoute = selectRoute(maneuver="bypass", place="road", lanes=2, opposite=False)
egoSpawnPt = startOf(egoRoute)
leftLane = neighbourPath(egoRoute, "left")
adjacentLane = leftLane
blockedLane = ownLane(egoRoute)
