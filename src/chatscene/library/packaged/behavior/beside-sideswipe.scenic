#: description = "The car keeps level with the ego and suddenly swerves at it."
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["pace", "swerve"]
#: position = "beside"
#: maneuver = "straight"
#: leader = false

param OPT_ADV_DISTANCE = Range(-25, 5)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_AHEAD = Range(-4, 5)  #: [m] how far ahead of the ego it stays
param OPT_SWERVE = Range(1.5, 2.5)  #: [m] how far it swerves
param OPT_SWERVE_TIME = Range(1, 1.6)  #: [s] for how long it swerves

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD, 16, 2.5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do SwerveOnPath(advLane, 7.5, -globalParameters.OPT_SWERVE if offsetFrom(egoRoute, self) > 0 else globalParameters.OPT_SWERVE) for globalParameters.OPT_SWERVE_TIME seconds
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD, 16, 2.5)
