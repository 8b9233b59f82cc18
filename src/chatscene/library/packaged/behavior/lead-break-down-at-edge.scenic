#: description = "The truck ahead breaks down, limps toward the edge of the road and stands half in the lane."
#: adversaries = ["car", "truck", "bus", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["slow", "swerve", "stop"]
#: position = "ahead"

param OPT_ADV_DISTANCE = Range(12, 40)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_AHEAD = Range(14, 24)  #: [m] how far ahead of the ego it drives before it acts
param OPT_BRAKE = Range(0.14, 0.2)  #: [1] how hard it brakes
param OPT_SWERVE = Range(1.3, 1.9)  #: [m] how far to the right of its line it comes to stand

behavior AdvBehavior():
    do PaceOnPath(advTrajectory, ego, globalParameters.OPT_ADV_AHEAD, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do SwerveOnPath(advTrajectory, 6, -globalParameters.OPT_SWERVE) for 0.8 seconds
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE, -globalParameters.OPT_SWERVE)
