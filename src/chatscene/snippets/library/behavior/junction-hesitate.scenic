#: description = "The car pulls into the intersection, hesitates, and drives on."
#: rephrasings = [
#:   "A vehicle noses out, pauses in doubt, and then goes.",
#:   "The adversary stops halfway in and shortly after continues across.",
#:   "The crossing driver starts, waits, and starts again.",
#:   "Undecided, the car halts at the edge of the ego's way and then crosses it.",
#:   "The other car creeps in, stands a moment, and moves off before the ego.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "ego", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["hesitate"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 18.0
#: high = 45.0
#: unit = "m"
#: meaning = "distance to the ego at which it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.0
#: high = 8.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 2.0
#: high = 6.0
#: unit = "m"
#: meaning = "how far from the ego's line it pauses"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.4
#: high = 1.5
#: unit = "s"
#: meaning = "how long it pauses"

param OPT_ADV_DISTANCE = Range(18, 45)
param OPT_ADV_SPEED = Range(3, 8)
param OPT_STOP_DISTANCE = Range(2, 6)
param OPT_STOP_TIME = Range(0.4, 1.5)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do BrakeOnPath(advTrajectory) until self.pose[3] < 0.05
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
