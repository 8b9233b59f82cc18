#: description = "The car makes a U-turn in the middle of the intersection."
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["u-turn"]

param OPT_ADV_DISTANCE = Range(16, 36)  #: [m] how far the ego still is from where their ways meet when the adversary gets there
param OPT_ADV_SPEED = Range(4, 7)  #: [m/s] how fast it drives
param OPT_SWERVE_DISTANCE = Range(0, 5)  #: [m] how far before the place where their ways meet it turns

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < globalParameters.OPT_SWERVE_DISTANCE
    do TurnOff(3, globalParameters.OPT_ADV_SPEED, 5)
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
