#: description = "The ego drives straight on a road with several lanes in its direction."
#: rephrasings = [
#:   "A multi-lane avenue; the ego keeps its lane.",
#:   "The ego goes straight ahead with another lane of the same direction beside it.",
#:   "A wide street with two lanes each way.",
#:   "Driving along a dual-lane carriageway without changing lanes.",
#:   "The ego cruises on a big road that has parallel lanes.",
#:   "we're just cruising along a big road with a couple of lanes our way",
#: ]
#: adversaries = []
#: requires = []
#: provides = ["adjacentLane", "egoRoute", "egoSpawnPt"]
#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: place = "road"
#: lanes = 2

egoRoute = selectRoute(maneuver="straight", place="road", lanes=2)
egoSpawnPt = startOf(egoRoute)
adjacentLane = adjacentPath(egoRoute)
