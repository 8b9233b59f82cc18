#: description = "The crossing vehicle runs the red light and brakes abruptly."
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "base scenario red-light-running; own code"
#: [slots]
#: actions = ["run-light", "brake"]
#: position = "crossing"
#: control = "signal"

param OPT_ADV_DISTANCE = Range(28, 56)  #: [m] how far the ego still is from where their ways meet when it sets off
param OPT_ADV_SPEED = Range(7, 11)  #: [m/s] how fast it drives
param OPT_STOP_DISTANCE = Range(0, 4.5)  #: [m] how far beyond where their ways meet it comes to rest

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory)
