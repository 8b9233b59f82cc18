# A pedestrian crosses from the right and stops in front of us.

model chatscene.world.model

AdvClass = Pedestrian

## behavior/cross-and-stop
param OPT_ADV_SPEED = Range(1.4, 5)
param OPT_ADV_DISTANCE = Range(10, 40)
param OPT_STOP_DISTANCE = Range(0, 1)

behavior AdvBehavior():
    # Earlier where it has farther to go, and briskly where the ego would be gone otherwise.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(5) until abs(offsetFrom(egoRoute, self)) < max(2.5, globalParameters.OPT_ADV_SPEED * headway(egoRoute, ego, self) / 8)
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt()

## geometry/straight-road
egoRoute = selectRoute(maneuver="straight", place="road")
egoSpawnPt = startOf(egoRoute)
kerbLane = ownLane(egoRoute)

ego = new Car at egoSpawnPt, facing directionOn(egoRoute, 0), with route egoRoute

## spawn/roadside-right
param OPT_GEO_Y = Range(22, 50)
param OPT_GEO_X = Range(1.2, 5)

# Not in the middle of an intersection, where the side of the road would be far away.
advLevel = shortOfJunction(egoRoute, globalParameters.OPT_GEO_Y)
AdvAgent = new AdvClass at besideRoad(egoRoute, advLevel, "right", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, advLevel, "right"),
    with behavior AdvBehavior()
