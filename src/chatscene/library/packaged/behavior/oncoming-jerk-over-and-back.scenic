#: description = "The oncoming car swerves over the centre line and jerks back at once."
#: adversaries = ["car", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "swerve", "turn-back"]
#: position = "oncoming"
#: maneuver = "straight"

param OPT_ADV_SPEED = Range(6, 11)  #: [m/s] how fast it drives
param OPT_ADV_DISTANCE = Range(34, 56)  #: [m] distance to the ego at which it swerves
param OPT_SWERVE = Range(2, 3.6)  #: [m] how far it swerves
param OPT_STOP_TIME = Range(0.9, 1.3)  #: [s] after how long it swerves back

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do SwerveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE) for globalParameters.OPT_STOP_TIME seconds
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
