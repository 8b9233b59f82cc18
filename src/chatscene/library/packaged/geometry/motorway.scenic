#: origin = "own code"
#: [slots]
#: place = "road"
#: [variants]
#: motorway                   = { maneuver = "straight", site = "motorway", lane = 2 }
#: motorway-outer-lane        = { maneuver = "straight", site = "motorway", lane = 1 }
#: motorway-lane-change-left  = { maneuver = "lane-change-left", site = "motorway", target = "left" }
#: motorway-lane-change-right = { maneuver = "lane-change-right", site = "motorway", target = "right" }
#: past-on-ramp               = { maneuver = "straight", site = "past-on-ramp" }
#: past-off-ramp              = { maneuver = "straight", site = "past-off-ramp" }
#: acceleration-lane          = { maneuver = "lane-change-left", site = "on-ramp", target = "left" }
#: off-ramp                   = { maneuver = "lane-change-right", site = "off-ramp", target = "right" }
#: [descriptions]
#: motorway                   = "The ego drives straight on along a motorway, with lanes of its direction on both sides."
#: motorway-outer-lane        = "The ego drives straight on along a motorway, in the outermost lane."
#: motorway-lane-change-left  = "The ego changes to the left lane of a motorway."
#: motorway-lane-change-right = "The ego changes to the right lane of a motorway."
#: past-on-ramp               = "The ego keeps its lane on a motorway where an on-ramp joins; traffic from the ramp is to its right."
#: past-off-ramp              = "The ego keeps its lane on a motorway past an off-ramp; the exit lane is to its right."
#: acceleration-lane          = "The ego merges from the acceleration lane of an on-ramp into the motorway lane to its left."
#: off-ramp                   = "The ego changes to the exit lane and leaves the motorway by the off-ramp."

egoRoute = selectRoute(maneuver="$maneuver", site="$site", lanes=3, lane=$lane)  #: if lane
egoRoute = selectRoute(maneuver="$maneuver", site="$site", lanes=2)  #: if target  #: unless site off-ramp
egoRoute = selectRoute(maneuver="$maneuver", site="$site", beside="right")  #: unless lane  #: unless target left  #: unless site motorway
egoSpawnPt = startOf(egoRoute)
laneLeft = leftAt(egoRoute)  #: if target
adjacentLane = neighbourPath(egoRoute, "$target")  #: if target
adjacentLane = neighbourPath(egoRoute, "left")  #: if lane 1
adjacentLane = neighbourPath(egoRoute, "right")  #: unless target  #: unless lane 1
${target}Lane = adjacentLane  #: if target
leftLane = adjacentLane  #: if lane 1
rightLane = adjacentLane  #: unless target  #: unless lane 1
leftLane = neighbourPath(egoRoute, "left")  #: unless target  #: unless lane 1
kerbLane = ownLane(egoRoute)  #: if lane 1
