#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: origin = "own code"
#: [slots]
#: side = "right"
#: position = "crossing"
#: maneuver = "straight"
#: [variants]
#: turn-right-merge-creep     = { actions = ["turn-right", "slow"], adv_distance = [2, 20], slow_speed = [2.8, 3.9] }
#: run-light-turn-right-creep = { actions = ["run-light", "turn-right", "slow"], adv_distance = [-5, 15], slow_speed = [2.5, 3.8], control = "signal" }
#: [descriptions]
#: turn-right-merge-creep     = "The car turns right into the ego's lane and crawls along in front of it."
#: run-light-turn-right-creep = "The crossing car turns right on red into the ego's lane and crawls along."

param OPT_ADV_DISTANCE = Range$adv_distance  #: [m] how far the ego still is from where their ways meet when the adversary gets there
param OPT_SLOW_SPEED = Range$slow_speed  #: [m/s] how fast it turns and goes on

advTurn = ("straight", "right-turn")

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_SLOW_SPEED  #: unless control
    do BrakeOnPath(advTrajectory) until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_SLOW_SPEED  #: if control
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED) until abs(offsetFrom(egoRoute, self)) < 6
    do DrivePath(egoRoute, globalParameters.OPT_SLOW_SPEED)
