#: description = "The ego follows a bend of a narrow two-way road, an oncoming lane beside it."
#: rephrasings = [
#:   "A winding country road with one lane each way.",
#:   "we're going round a bend and there's oncoming traffic right next to us",
#:   "two-lane rural road, curve, opposing lane adjacent",
#:   "Vehicle 1 was negotiating a curve on an undivided two-lane roadway.",
#:   "The VUT follows a curved road section with a single carriageway and opposing lane.",
#:   "The ego car drives in the bending road, near to lane of the opposite direction.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "kerbLane", "oppositeLane"]
#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: place = "curve"
#: lanes = 1
#: two_way = true

egoRoute = selectRoute(maneuver="straight", place="curve", opposite=True, beside="none")
egoSpawnPt = startOf(egoRoute)
oppositeLane = neighbourPath(egoRoute, "left")
kerbLane = ownLane(egoRoute)
