# A pedestrian steps out from behind a bus stop on the right and freezes in front of us.

model chatscene.world.model

AdvClass = Pedestrian

## behavior/walker-plant-in-lane
param OPT_ADV_SPEED = Range(1.1, 1.8)
param OPT_ADV_DISTANCE = Range(30, 48)
param OPT_STOP_DISTANCE = Range(0.2, 1.25)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 3.5
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt()

## geometry/straight-road
egoRoute = selectRoute(maneuver="straight", place="road")
egoSpawnPt = startOf(egoRoute)
kerbLane = ownLane(egoRoute)

ego = new Car at egoSpawnPt, facing directionOn(egoRoute, 0), with route egoRoute

## spawn/behind-bus-stop-right
param OPT_GEO_Y = Range(22, 50)
param OPT_GEO_X = Range(1.5, 2.3)
param OPT_BLOCKER_GAP = Range(2.7, 4.4)

# Not in the middle of an intersection, where the side of the road would be far away.
advLevel = shortOfJunction(egoRoute, globalParameters.OPT_GEO_Y)
new BusStop at besideRoad(egoRoute, advLevel - globalParameters.OPT_BLOCKER_GAP, "right", 1.6),
    facing directionOn(egoRoute, advLevel - globalParameters.OPT_BLOCKER_GAP),
    with label "bus-stop"
AdvAgent = new AdvClass at besideRoad(egoRoute, advLevel, "right", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, advLevel, "right"),
    with behavior AdvBehavior()
