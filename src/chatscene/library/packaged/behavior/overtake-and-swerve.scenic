#: description = "The car overtakes the ego and swerves at it while passing."
#: adversaries = ["car", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["overtake", "swerve"]
#: position = "behind-beside"
#: maneuver = "straight"

param OPT_ADV_SPEED = Range(11, 13)  #: [m/s] how fast it overtakes
param OPT_ADV_AHEAD = Range(-2, 3)  #: [m] how far ahead of the ego it is when it swerves
param OPT_SWERVE = Range(1.6, 2.5)  #: [m] how far it swerves
param OPT_SWERVE_TIME = Range(1, 1.6)  #: [s] for how long it swerves

behavior AdvBehavior():
    do DrivePath(advLane, globalParameters.OPT_ADV_SPEED) until headway(egoRoute, ego, self) > globalParameters.OPT_ADV_AHEAD
    do SwerveOnPath(advLane, globalParameters.OPT_ADV_SPEED, -globalParameters.OPT_SWERVE if offsetFrom(ownLane(egoRoute), self) > 0 else globalParameters.OPT_SWERVE) for globalParameters.OPT_SWERVE_TIME seconds
    do DrivePath(advLane, globalParameters.OPT_ADV_SPEED)
