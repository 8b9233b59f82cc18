#: description = "The car ahead swings out around something, comes back into its lane and brakes."
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["swerve", "brake"]
#: position = "ahead"

param OPT_ADV_DISTANCE = Range(-5, 30)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_SWERVE = Range(1.5, 2.6)  #: [m] how far it swerves
param OPT_SWERVE_TIME = Range(0.8, 1.5)  #: [s] for how long it swerves
param OPT_BRAKE = Range(0.5, 1)  #: [1] how hard it brakes

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do SwerveOnPath(advTrajectory, 7, globalParameters.OPT_SWERVE) for globalParameters.OPT_SWERVE_TIME seconds
    do DrivePath(advTrajectory, 6) until abs(offsetFrom(advTrajectory, self)) < 0.6
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.3
    do DrivePath(advTrajectory, 3)
