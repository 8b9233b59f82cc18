#: description = "The crossing car runs the red light and swerves to its left in the junction."
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "swerve"]
#: position = "crossing"
#: control = "signal"

param OPT_ADV_DISTANCE = Range(26, 54)  #: [m] how far the ego still is from where their ways meet when it sets off
param OPT_ADV_SPEED = Range(7, 11)  #: [m/s] how fast it drives
param OPT_SWERVE = Range(1.4, 3)  #: [m] how far it swerves to its left
param OPT_SWERVE_DISTANCE = Range(2, 9)  #: [m] how far before the place where their ways meet it swerves

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < globalParameters.OPT_SWERVE_DISTANCE
    do SwerveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE)
