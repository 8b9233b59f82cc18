#: description = "The car enters the intersection, stops, and reverses."
#: rephrasings = [
#:   "A vehicle noses into the junction, halts, and backs up.",
#:   "The adversary rolls in, stands still, then moves backward.",
#:   "The crossing driver thinks better of it and goes into reverse.",
#:   "Having stopped on the crossroads, the car backs out again.",
#:   "The other car pulls in before the ego and then drives backwards.",
#: ]
#: adversaries = ["car", "truck", "bus"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["stop", "reverse"]
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
#: meaning = "how fast it comes in"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.0
#: high = 4.5
#: unit = "m"
#: meaning = "how far beyond where their ways meet it stops"
#: [[parameters]]
#: name = "OPT_ADV_BACK"
#: low = 1.5
#: high = 4.0
#: unit = "m/s"
#: meaning = "how fast it backs up"
#: [[parameters]]
#: name = "OPT_ADV_BACK_TIME"
#: low = 1.0
#: high = 4.0
#: unit = "s"
#: meaning = "for how long"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_SPEED = Range(3, 8)
param OPT_STOP_DISTANCE = Range(0, 4.5)
param OPT_ADV_BACK = Range(1.5, 4)
param OPT_ADV_BACK_TIME = Range(1, 4)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory) until self.pose[3] < 0.05
    do Halt() for 0.5 seconds
    do ReverseStraight(globalParameters.OPT_ADV_BACK) for globalParameters.OPT_ADV_BACK_TIME seconds
    do Halt()
