#: description = "The crossing vehicle runs the red light at a steady speed."
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: origin = "base scenario red-light-running; own code"
#: [slots]
#: actions = ["run-light"]
#: position = "crossing"
#: control = "signal"

param OPT_ADV_DISTANCE = Range(12, 48)  #: [m] how far the ego still is from where their ways meet when it sets off
param OPT_ADV_SPEED = Range(6, 13)  #: [m/s] how fast it crosses

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
