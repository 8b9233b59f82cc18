#: description = "The slow oncoming truck hugs the centre of the road."
#: adversaries = ["truck", "bus"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "slow", "follow"]
#: position = "oncoming"
#: maneuver = "straight"

param OPT_ADV_SPEED = Range(2.2, 3.8)  #: [m/s] how fast it drives
param OPT_SWERVE = Range(0.7, 1.6)  #: [m] how far towards the ego's side it keeps

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE)
