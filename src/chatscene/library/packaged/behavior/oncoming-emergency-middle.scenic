#: description = "The oncoming emergency vehicle races down the middle of the road."
#: adversaries = ["emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "fast", "follow"]
#: position = "oncoming"
#: maneuver = "straight"

param OPT_ADV_SPEED = Range(12, 17)  #: [m/s] how fast it drives
param OPT_SWERVE = Range(1.2, 2.2)  #: [m] how far towards the ego's side it keeps

behavior AdvBehavior():
    do ThrottleOnPath(advTrajectory, 1, globalParameters.OPT_SWERVE, globalParameters.OPT_ADV_SPEED)
