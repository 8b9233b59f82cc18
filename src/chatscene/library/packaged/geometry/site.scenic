#: origin = "own code"
#: [variants]
#: on-ramp    = { maneuver = "lane-change-left", place = "road", site = "on-ramp" }
#: roundabout = { maneuver = "straight", place = "junction", site = "roundabout" }
#: rural-road = { maneuver = "straight", place = "road", site = "rural", lanes = 1, two_way = true }
#: crosswalk  = { maneuver = "straight", place = "road", site = "crosswalk" }
#: [descriptions]
#: on-ramp    = "The ego comes down an on-ramp and merges onto the motorway."
#: roundabout = "The ego drives straight through a roundabout."
#: rural-road = "The ego drives straight on along a rural road with one lane in each direction."
#: crosswalk  = "The ego drives straight on towards a crosswalk between junctions."

egoRoute = selectRoute(maneuver="$maneuver", site="$site")  #: unless site rural
egoRoute = selectRoute(maneuver="$maneuver", site="$site", opposite=True, beside="none")  #: if site rural
egoSpawnPt = startOf(egoRoute)
oppositeLane = neighbourPath(egoRoute, "left")  #: if site rural
kerbLane = ownLane(egoRoute)  #: unless site on-ramp  #: unless site roundabout
