#: description = "The crossing car turns right on red into the ego's lane and stops there."
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "turn-right", "stop"]
#: side = "right"
#: position = "crossing"
#: maneuver = "straight"
#: control = "signal"

param OPT_ADV_DISTANCE = Range(24, 44)  #: [m] how far the ego still is from where their ways meet when the adversary gets there
param OPT_ADV_SPEED = Range(5, 8)  #: [m/s] how fast it turns
param OPT_STOP_TIME = Range(0.6, 1.4)  #: [s] how long it goes on in the ego's lane before it stops

advTurn = ("straight", "right-turn")

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 6
    do DrivePath(egoRoute, globalParameters.OPT_ADV_SPEED) for globalParameters.OPT_STOP_TIME seconds
    do BrakeOnPath(egoRoute, 0.6)
