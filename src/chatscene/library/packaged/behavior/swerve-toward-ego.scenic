#: description = "The car swerves toward the ego's lane and straightens up again."
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["swerve"]

param OPT_ADV_DISTANCE = Range(-8, 24)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_SPEED = Range(5, 9)  #: [m/s] how fast it drives
param OPT_SWERVE = Range(1.5, 2.6)  #: [m] how far it swerves
param OPT_SWERVE_TIME = Range(1.2, 1.8)  #: [s] for how long

behavior AdvBehavior():
    others = [other for other in simulation().objects if other.body is not self.body and other.body is not ego.body]
    # At the latest where it would pass somebody else.
    do KeepStation(advLane, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE or any(0 < headway(advLane, self, other) < 32 for other in others)
    do SwerveOnPath(advLane, globalParameters.OPT_ADV_SPEED, -globalParameters.OPT_SWERVE if offsetFrom(ownLane(egoRoute), self) > 0 else globalParameters.OPT_SWERVE) for globalParameters.OPT_SWERVE_TIME seconds
    do DrivePath(advLane, globalParameters.OPT_ADV_SPEED)
