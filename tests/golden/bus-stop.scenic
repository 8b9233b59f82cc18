# A pedestrian steps out from behind a bus stop on the right and freezes in front of us.

model chatscene.world.model

AdvClass = Pedestrian

## behavior/cross-and-stop
param OPT_ADV_SPEED = Range(1.2, 5)
param OPT_ADV_DISTANCE = Range(6, 40)
param OPT_STOP_DISTANCE = Range(0, 1)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt()

## geometry/straight-road
egoRoute = selectRoute(maneuver="straight", place="road")
egoSpawnPt = startOf(egoRoute)

ego = new Car at egoSpawnPt, facing directionOn(egoRoute, 0), with route egoRoute

## spawn/behind-bus-stop-right
param OPT_GEO_Y = Range(22, 50)
param OPT_GEO_X = Range(1.3, 2.6)
param OPT_BLOCKER_GAP = Range(2.7, 4.4)

new BusStop at besideRoad(egoRoute, globalParameters.OPT_GEO_Y - globalParameters.OPT_BLOCKER_GAP, "right", 1.6),
    facing directionOn(egoRoute, globalParameters.OPT_GEO_Y - globalParameters.OPT_BLOCKER_GAP),
    with label "bus-stop"
AdvAgent = new AdvClass at besideRoad(egoRoute, globalParameters.OPT_GEO_Y, "right", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, globalParameters.OPT_GEO_Y, "right"),
    with behavior AdvBehavior()
