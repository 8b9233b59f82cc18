#: description = "The oncoming car turns left across the ego's path, stops, and reverses."
#: adversaries = ["car", "truck", "bus"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "turn-left", "stop", "reverse"]
#: position = "oncoming"
#: maneuver = "straight"

param OPT_ADV_DISTANCE = Range(34, 56)  #: [m] how far the ego still is from where their ways meet when the adversary gets there
param OPT_ADV_SPEED = Range(5, 8)  #: [m/s] how fast it drives
param OPT_STOP_DISTANCE = Range(5.5, 8)  #: [m] how far beyond where their ways meet it comes to rest
param OPT_ADV_BACK = Range(1.5, 3)  #: [m/s] how fast it backs up
param OPT_ADV_BACK_TIME = Range(0.8, 2)  #: [s] for how long it backs up

advTurn = "left-turn"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory) until self.pose[3] < 0.05
    do Halt() for 0.5 seconds
    do ReverseStraight(globalParameters.OPT_ADV_BACK) for globalParameters.OPT_ADV_BACK_TIME seconds
    do Halt()
