#: description = "The car enters the intersection, swerves to its left, and stops."
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["swerve", "stop"]

param OPT_ADV_DISTANCE = Range(14, 32)  #: [m] how far the ego still is from where their ways meet when the adversary gets there
param OPT_ADV_SPEED = Range(6, 10)  #: [m/s] how fast it drives
param OPT_SWERVE = Range(1.5, 3)  #: [m] how far it swerves to its left
param OPT_SWERVE_DISTANCE = Range(4, 9)  #: [m] how far before the place where their ways meet it swerves
param OPT_STOP_DISTANCE = Range(0, 3)  #: [m] how far beyond where their ways meet it comes to rest

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < globalParameters.OPT_SWERVE_DISTANCE + brakingDistance(self)
    do SwerveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory, 1, globalParameters.OPT_SWERVE)
