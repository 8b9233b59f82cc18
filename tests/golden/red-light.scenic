# We drive straight when a truck from the left runs the red light and brakes.

model chatscene.world.model

AdvClass = Truck

## behavior/run-light-brake
param OPT_ADV_DISTANCE = Range(28, 56)
param OPT_ADV_SPEED = Range(7, 11)
param OPT_STOP_DISTANCE = Range(0, 4.5)

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory)

## geometry/straight-signalised
param signals = 'ego-green'
crossSignal = "red"
egoRoute = selectRoute(maneuver="straight", place="four-way", control="signal", crossed=("left", "right", "oncoming"))
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")
trafficFromRight = trafficFrom(egoRoute, "right")
oncomingTraffic = trafficFrom(egoRoute, "oncoming")

ego = new Car at egoSpawnPt, facing directionOn(egoRoute, 0), with route egoRoute

## spawn/crossing-from-left
param OPT_GEO_Y = Range(3.5, 20)

advTrajectory = wayOf(trafficFromLeft, advTurn)
advMeeting = advTrajectory.meets_at
egoMeeting = advTrajectory.ego_meets_at
AdvAgent = new AdvClass at pointOn(advTrajectory, advTrajectory.entry - globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, advTrajectory.entry - globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
