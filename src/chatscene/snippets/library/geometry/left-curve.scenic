#: description = "The ego follows a two-way road that bends to the left."
#: rephrasings = [
#:   "A left-hand bend.",
#:   "the road swings round to the left and we follow it",
#:   "left curve, 1 lane per direction",
#:   "Vehicle 1 was negotiating a left curve.",
#:   "The VUT travels through a bend of the road that turns to the left, opposing lane adjacent.",
#:   "The ego car is driving in the street which makes the curve to left hand.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "kerbLane", "oppositeLane"]
#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: place = "left-curve"
#: lanes = 1
#: two_way = true

egoRoute = selectRoute(maneuver="straight", place="left-curve", opposite=True, beside="none")
egoSpawnPt = startOf(egoRoute)
oppositeLane = neighbourPath(egoRoute, "left")
kerbLane = ownLane(egoRoute)
