#: description = "The car enters the intersection, stops, and reverses."
#: rephrasings = [
#:   "A vehicle noses into the junction, halts, and backs up.",
#:   "The adversary rolls in, stands still, then moves backward.",
#:   "The crossing driver thinks better of it and goes into reverse.",
#:   "Having stopped on the crossroads, the car backs out again.",
#:   "The other car pulls in before the ego and then drives backwards.",
#: ]
#: adversaries = ["car", "truck", "bus"]
#: requires = ["advTrajectory", "ego", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["stop", "reverse"]
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
#: meaning = "how fast it comes in"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.0
#: high = 5.0
#: unit = "m"
#: meaning = "how far from the ego's line it stops"
#: [[parameters]]
#: name = "OPT_ADV_BACK"
#: low = 1.5
#: high = 4.0
#: unit = "m/s"
#: meaning = "how fast it backs up"

param OPT_ADV_DISTANCE = Range(18, 45)
param OPT_ADV_SPEED = Range(3, 8)
param OPT_STOP_DISTANCE = Range(0, 5)
param OPT_ADV_BACK = Range(1.5, 4)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do BrakeOnPath(advTrajectory) until self.pose[3] < 0.05
    do Halt() for 0.5 seconds
    do ReverseStraight(globalParameters.OPT_ADV_BACK)
