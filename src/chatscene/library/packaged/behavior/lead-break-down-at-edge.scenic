#: description = "The truck ahead breaks down, limps toward the edge of the road and stands half in the lane."
#: adversaries = ["car", "truck", "bus", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["slow", "swerve", "stop"]
#: position = "ahead"

param OPT_ADV_DISTANCE = Range(0, 30)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_BRAKE = Range(0.17, 0.24)  #: [1] how hard it brakes
param OPT_SWERVE = Range(1.1, 1.8)  #: [m] how far to the right of its line it comes to stand

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE, -globalParameters.OPT_SWERVE)
