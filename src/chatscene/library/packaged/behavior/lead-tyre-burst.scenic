#: description = "The car ahead bursts a tyre, swerves and brakes to a stop across its lane."
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["swerve", "brake", "stop"]
#: position = "ahead"

param OPT_ADV_DISTANCE = Range(-10, 20)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_SWERVE = Range(1.6, 2.6)  #: [m] how far it swerves
param OPT_BRAKE = Range(0.5, 1)  #: [1] how hard it brakes

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do SwerveOnPath(advTrajectory, 6, globalParameters.OPT_SWERVE) for 0.8 seconds
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE, 0.5 * globalParameters.OPT_SWERVE)
