#: description = "The car enters the intersection and suddenly swerves to the right."
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "base scenario right-turn; own code"
#: [slots]
#: actions = ["swerve"]

param OPT_ADV_DISTANCE = Range(28, 56)  #: [m] how far the ego still is from where their ways meet when it sets off
param OPT_ADV_SPEED = Range(6, 10)  #: [m/s] how fast it drives
param OPT_SWERVE = Range(1, 3)  #: [m] how far it swerves
param OPT_SWERVE_DISTANCE = Range(2, 9)  #: [m] how far before the place where their ways meet it swerves

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < globalParameters.OPT_SWERVE_DISTANCE
    do SwerveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, -globalParameters.OPT_SWERVE)
