#: description = "The oncoming car turns right into the road the ego is taking and crawls along."
#: adversaries = ["car", "truck", "bus"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "turn-right", "slow"]
#: position = "oncoming"
#: maneuver = "left-turn"

param OPT_ADV_DISTANCE = Range(-5, 15)  #: [m] how far the ego still is from where their ways meet when the adversary gets there
param OPT_SLOW_SPEED = Range(2.5, 3.8)  #: [m/s] how fast it turns

advTurn = "straight"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_SLOW_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED) until abs(offsetFrom(egoRoute, self)) < 6
    do DrivePath(egoRoute, globalParameters.OPT_SLOW_SPEED)
