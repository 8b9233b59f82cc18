#: description = "The crossing car brakes too late for the red light, slides over the line, and stops with its nose in the junction."
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "brake", "stop"]
#: position = "crossing"
#: control = "signal"

param OPT_ADV_DISTANCE = Range(0, 22)  #: [m] how far the ego still is from where their ways meet when the adversary gets there
param OPT_ADV_SPEED = Range(7, 11)  #: [m/s] how fast it comes in
param OPT_STOP_DISTANCE = Range(-4.5, -1.5)  #: [m] how far beyond where their ways meet it comes to rest

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory)
