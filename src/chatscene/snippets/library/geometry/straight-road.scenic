#: description = "The ego vehicle drives on a straight road."
#: rephrasings = [
#:   "A straight street without junctions.",
#:   "The ego goes straight ahead along a road.",
#:   "The car under test follows an ordinary straight carriageway.",
#:   "Driving on a plain stretch of road that does not bend.",
#:   "A level, direct road lies before the ego.",
#:   "The VUT drives in a straight line on a straight lane.",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["egoRoute", "egoSpawnPt", "kerbLane"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: maneuver = "straight"
#: place = "road"

egoRoute = selectRoute(maneuver="straight", place="road")
egoSpawnPt = startOf(egoRoute)
kerbLane = ownLane(egoRoute)
