#: description = "The rider ahead swings out slowly round something on the road and back into line."
#: adversaries = ["bicycle", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["swerve", "slow"]
#: position = "ahead"

param OPT_ADV_SPEED = Range(1.8, 2.8)  #: [m/s] how fast it rides
param OPT_ADV_DISTANCE = Range(0, 18)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_SWERVE = Range(1.1, 1.8)  #: [m] how far it swings out to the left
param OPT_ADV_TIME = Range(2.5, 4)  #: [s] how long it stays out

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego, 4) until self.pose[3] > 3.5 and (distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE or headway(egoRoute, ego, self) < 12)
    do SwerveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE) for globalParameters.OPT_ADV_TIME seconds
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
