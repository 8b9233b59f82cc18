#: description = "The rider ahead swings out to the left and stops there."
#: adversaries = ["bicycle", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["swerve", "stop"]
#: position = "ahead"
#: maneuver = "straight"

param OPT_ADV_SPEED = Range(3.5, 5.5)  #: [m/s] how fast it rides
param OPT_ADV_DISTANCE = Range(0, 25)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_SWERVE = Range(0.95, 1.3)  #: [m] how far it swings out to the left
param OPT_BRAKE = Range(0.4, 0.8)  #: [1] how hard it brakes

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego, 4) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do SwerveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE) for 1.2 seconds
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE, globalParameters.OPT_SWERVE)
