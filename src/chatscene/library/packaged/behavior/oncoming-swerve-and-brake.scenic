#: description = "The oncoming car swerves into the ego's lane, brakes hard, and stops there."
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "swerve", "brake", "stop"]
#: position = "oncoming"
#: maneuver = "straight"

param OPT_ADV_SPEED = Range(7, 11)  #: [m/s] how fast it drives
param OPT_ADV_DISTANCE = Range(32, 56)  #: [m] distance to the ego at which it swerves
param OPT_SWERVE = Range(2.2, 3.8)  #: [m] how far it swerves
param OPT_STOP_TIME = Range(0.6, 1)  #: [s] how long after it swerved it brakes

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until self.pose[3] > 5 and gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do SwerveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE) for globalParameters.OPT_STOP_TIME seconds
    do BrakeOnPath(advTrajectory, 0.8, globalParameters.OPT_SWERVE)
