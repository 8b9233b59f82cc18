#: description = "The emergency vehicle comes toward the ego at speed on the wrong side, in the ego's lane, and moves over only at the last moment."
#: adversaries = ["emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "wrong-way", "fast"]
#: position = "oncoming"
#: maneuver = "straight"
#: place = "road"

param OPT_ADV_DISTANCE = Range(55, 80)  #: [m] how far the ego still has to go to it when it moves off
param OPT_ADV_SPEED = Range(11.5, 14)  #: [m/s] how fast it drives
param OPT_SWERVE_DISTANCE = Range(5, 30)  #: [m] how far from the ego it moves back

behavior AdvBehavior():
    do DrivePath(advTrajectory, 8) until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(against(ownLane(egoRoute)), 1, 0, globalParameters.OPT_ADV_SPEED) until headway(egoRoute, ego, self) < globalParameters.OPT_SWERVE_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
