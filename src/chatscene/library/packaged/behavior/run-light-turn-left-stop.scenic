#: description = "The crossing car runs the red light, turns left, and stops in the turn."
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "turn-left", "stop"]
#: side = "right"
#: position = "crossing"
#: maneuver = "straight"
#: control = "signal"

param OPT_ADV_DISTANCE = Range(32, 52)  #: [m] how far the ego still is from where their ways meet when the adversary gets there
param OPT_ADV_SPEED = Range(6, 8.5)  #: [m/s] how fast it turns
param OPT_STOP_DISTANCE = Range(4, 8)  #: [m] how far beyond where their ways meet it comes to rest

advTurn = "left-turn"

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory)
