#: description = "The crossing car shoots through the red light at high speed."
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "NHTSA pre-crash typology: running red light; own code"
#: [slots]
#: actions = ["run-light", "fast"]
#: position = "crossing"
#: control = "signal"

param OPT_ADV_DISTANCE = Range(25, 60)  #: [m] how far the ego still is from where their ways meet when it sets off
param OPT_ADV_SPEED = Range(12.5, 17)  #: [m/s] how fast it shoots across

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, 1, 0, globalParameters.OPT_ADV_SPEED)
