# While we change to the left lane, a motorcycle ahead in that lane brakes hard.

model chatscene.world.model

AdvClass = Motorcycle

## behavior/lane-brake
param OPT_ADV_DISTANCE = Range(-15, 20)
param OPT_BRAKE = Range(0.4, 1)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)

## geometry/lane-change-left
egoRoute = selectRoute(maneuver="lane-change-left", lanes=2)
egoSpawnPt = startOf(egoRoute)
laneLeft = leftAt(egoRoute)
adjacentLane = neighbourPath(egoRoute, "left")
leftLane = adjacentLane

ego = new Car at egoSpawnPt, facing directionOn(egoRoute, 0), with route egoRoute

## spawn/left-lane-ahead
param OPT_GEO_Y = Range(6, 22)

advTrajectory = leftLane
advLane = advTrajectory
AdvAgent = new AdvClass at pointOn(advTrajectory, globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
