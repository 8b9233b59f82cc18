#: description = "The ego must use the opposite lane to go around a vehicle parked in its lane."
#: rephrasings = [
#:   "The ego's lane is obstructed, so it passes through the lane of oncoming traffic.",
#:   "The ego swings into the opposing lane to bypass an obstacle.",
#:   "The car under test goes round something that stands in its way, against the traffic for a moment.",
#:   "On a two-way road the ego overtakes a standing car on the wrong side.",
#:   "A detour over the centre line and back.",
#:   "we've got to pull out round a parked car, into the oncoming lane",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["blockedLane", "egoRoute", "egoSpawnPt", "oppositeLane"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: maneuver = "bypass"
#: place = "road"
#: lanes = 1
#: two_way = true

egoRoute = selectRoute(maneuver="bypass", place="road", opposite=True)
egoSpawnPt = startOf(egoRoute)
oppositeLane = neighbourPath(egoRoute, "left")
blockedLane = ownLane(egoRoute)
