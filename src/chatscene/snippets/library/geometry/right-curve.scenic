#: description = "The ego follows a two-way road that bends to the right."
#: rephrasings = [
#:   "A right-hand bend.",
#:   "there's a right-hander coming up and we just steer round it",
#:   "right curve, 1 lane per direction",
#:   "The roadway curved to the right, one lane in each direction, no intersection.",
#:   "The VUT travels through a bend of the road that turns to the right, opposing lane adjacent.",
#:   "The ego car is driving in the street which makes the curve to right hand.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "kerbLane", "oppositeLane"]
#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: place = "right-curve"
#: lanes = 1
#: two_way = true

egoRoute = selectRoute(maneuver="straight", place="right-curve", opposite=True, beside="none")
egoSpawnPt = startOf(egoRoute)
oppositeLane = neighbourPath(egoRoute, "left")
kerbLane = ownLane(egoRoute)
