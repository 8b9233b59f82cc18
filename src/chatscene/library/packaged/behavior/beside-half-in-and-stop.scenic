#: description = "The car noses half into the ego's lane and stops there, straddling the line."
#: adversaries = ["car", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["swerve", "stop"]
#: maneuver = "straight"
#: leader = false

param OPT_ADV_DISTANCE = Range(0, 30)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_AHEAD = Range(12, 18)  #: [m] how far ahead of the ego it stays
param OPT_SWERVE = Range(1.25, 1.7)  #: [m] how far it noses over
param OPT_BRAKE = Range(0.4, 0.8)  #: [1] how hard it brakes

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and headway(egoRoute, ego, self) > 8
    do SwerveOnPath(advLane, 7.5, -globalParameters.OPT_SWERVE if offsetFrom(egoRoute, self) > 0 else globalParameters.OPT_SWERVE) for 0.8 seconds
    do BrakeOnPath(advLane, globalParameters.OPT_BRAKE, -globalParameters.OPT_SWERVE if offsetFrom(egoRoute, self) > 0 else globalParameters.OPT_SWERVE)
