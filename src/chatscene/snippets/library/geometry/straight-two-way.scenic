#: description = "The ego drives straight on a narrow two-way road with one lane in each direction."
#: rephrasings = [
#:   "A single-lane street with opposing traffic right beside the ego.",
#:   "Two lanes in all: one for the ego, one for those who come the other way.",
#:   "The ego keeps to its side of an undivided two-way street.",
#:   "A country-style road, one lane per direction, oncoming vehicles next to the ego.",
#:   "A straight road with a lane of opposite traffic.",
#:   "Vehicle 1 was traveling on an undivided two-lane roadway.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "kerbLane", "oppositeLane"]
#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: place = "road"
#: lanes = 1
#: two_way = true

egoRoute = selectRoute(maneuver="straight", place="road", opposite=True, beside="none")
egoSpawnPt = startOf(egoRoute)
oppositeLane = neighbourPath(egoRoute, "left")
kerbLane = ownLane(egoRoute)
