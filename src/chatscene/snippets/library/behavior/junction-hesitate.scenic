#: description = "The car pulls into the intersection, hesitates, and drives on."
#: rephrasings = [
#:   "A vehicle noses out, pauses in doubt, and then goes.",
#:   "The adversary stops halfway in and shortly after continues across.",
#:   "The crossing driver starts, waits, and starts again.",
#:   "Undecided, the car halts at the edge of the ego's way and then crosses it.",
#:   "The other car creeps in, stands a moment, and moves off before the ego.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["hesitate"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.0
#: high = 8.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = -3.0
#: high = 2.0
#: unit = "m"
#: meaning = "how far beyond where their ways meet it pauses"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.4
#: high = 1.5
#: unit = "s"
#: meaning = "how long it pauses"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_SPEED = Range(3, 8)
param OPT_STOP_DISTANCE = Range(-3, 2)
param OPT_STOP_TIME = Range(0.4, 1.5)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory) until self.pose[3] < 0.05
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
