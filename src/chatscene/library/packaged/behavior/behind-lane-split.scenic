#: description = "The motorcycle squeezes past the ego inside its lane and brakes in front of it."
#: adversaries = ["motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["overtake", "swerve", "brake"]
#: position = "behind"

param OPT_SWERVE = Range(1.85, 2.2)  #: [m] how far beside the ego's line it passes
param OPT_ADV_AHEAD = Range(5, 9)  #: [m] how far ahead of the ego it is when it moves over
param OPT_BRAKE = Range(0.5, 1)  #: [1] how hard it brakes

behavior AdvBehavior():
    do DrivePath(advTrajectory, 11, globalParameters.OPT_SWERVE) until headway(egoRoute, ego, self) > globalParameters.OPT_ADV_AHEAD
    do SwerveOnPath(advTrajectory, 8, 0) until abs(offsetFrom(advTrajectory, self)) < 0.8
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 1
    do DrivePath(advTrajectory, 4)
