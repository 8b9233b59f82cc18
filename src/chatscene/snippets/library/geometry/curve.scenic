#: description = "The ego drives around a curve of the road."
#: rephrasings = [
#:   "A bend in the street.",
#:   "The ego follows a road that turns gradually.",
#:   "The car under test takes a sweeping curve.",
#:   "The carriageway winds to one side.",
#:   "A bending road with no junction.",
#:   "Vehicle 1 was negotiating a curve.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "kerbLane"]
#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: place = "curve"

egoRoute = selectRoute(maneuver="straight", place="curve")
egoSpawnPt = startOf(egoRoute)
kerbLane = ownLane(egoRoute)
