#: origin = "own code"
#: [slots]
#: place = "junction"
#: lanes = 2
#: [variants]
#: left-turn-lane-on-right         = { maneuver = "left-turn", beside = "right", crossed = ["left", "right"] }
#: right-turn-lane-on-left         = { maneuver = "right-turn", beside = "left", crossed = ["left"] }
#: straight-junction-lane-on-left  = { maneuver = "straight", beside = "left", crossed = ["oncoming"] }
#: straight-junction-lane-on-right = { maneuver = "straight", beside = "right", crossed = ["left", "right"] }
#: [descriptions]
#: left-turn-lane-on-right         = "The ego turns left at an intersection from the left of two lanes."
#: right-turn-lane-on-left         = "The ego turns right at an intersection from the right of two lanes."
#: straight-junction-lane-on-left  = "The ego approaches an intersection in the right of two lanes and drives straight through."
#: straight-junction-lane-on-right = "The ego approaches an intersection in the left of two lanes and drives straight through."

egoRoute = selectRoute(maneuver="$maneuver", place="junction", lanes=2, beside="$beside", crossed=$crossed)
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
adjacentLane = neighbourPath(egoRoute, "$beside")
${beside}Lane = adjacentLane
trafficFromLeft = trafficFrom(egoRoute, "left")  #: if crossed left
trafficFromRight = trafficFrom(egoRoute, "right")  #: if crossed right
oncomingTraffic = trafficFrom(egoRoute, "oncoming")  #: if crossed oncoming
