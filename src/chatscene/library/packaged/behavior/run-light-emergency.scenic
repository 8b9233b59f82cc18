#: description = "The emergency vehicle accelerates hard through the red light with lights and siren on."
#: adversaries = ["emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "accelerate", "fast"]
#: position = "crossing"
#: control = "signal"

param OPT_ADV_DISTANCE = Range(25, 60)  #: [m] how far the ego still is from where their ways meet when it sets off
param OPT_ADV_SPEED = Range(12, 17)  #: [m/s] how fast it becomes
param OPT_THROTTLE = Range(0.7, 1)  #: [1] how far the pedal is pressed

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, globalParameters.OPT_ADV_SPEED)
