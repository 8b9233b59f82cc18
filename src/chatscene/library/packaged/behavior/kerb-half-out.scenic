#: description = "The parked car noses halfway out of its space and stops with its front in the ego's lane."
#: adversaries = ["car", "truck", "bus", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["stop"]
#: side = "right"
#: position = "kerb"

param OPT_ADV_DISTANCE = Range(16, 34)  #: [m] how far the ego still has to go to it when it moves off
param OPT_SWERVE = Range(0.8, 1.35)  #: [m] how far it noses out
param OPT_BRAKE = Range(0.3, 0.8)  #: [1] how hard it brakes

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3, -globalParameters.OPT_SWERVE if offsetFrom(ownLane(egoRoute), self) > 0 else globalParameters.OPT_SWERVE) until abs(offsetFrom(advKerb, self)) > 0.7 * globalParameters.OPT_SWERVE
    do BrakeOnPath(advKerb, globalParameters.OPT_BRAKE, -globalParameters.OPT_SWERVE if offsetFrom(ownLane(egoRoute), self) > 0 else globalParameters.OPT_SWERVE)
