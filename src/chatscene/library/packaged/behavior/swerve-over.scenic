#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "swerve"]
#: position = "oncoming"
#: [variants]
#: oncoming-swerve       = { blocker = false, adv_speed = [4, 10], adv_distance = [12, 40], swerve = [1.5, 3.5] }
#: oncoming-rider-swerve = { adv_speed = [4, 10], adv_distance = [12, 40], swerve = [1.2, 1.9], maneuver = "bypass", adversaries = ["bicycle", "motorcycle"] }
#: [descriptions]
#: oncoming-swerve       = "The oncoming car unexpectedly swerves into the ego's lane."
#: oncoming-rider-swerve = "The oncoming motorcyclist unexpectedly swerves into the lane the ego is using."

param OPT_ADV_SPEED = Range$adv_speed  #: [m/s] how fast it goes
param OPT_ADV_DISTANCE = Range$adv_distance  #: [m] distance to the ego at which it swerves
param OPT_SWERVE = Range$swerve  #: [m] how far it swerves

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do SwerveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE)
