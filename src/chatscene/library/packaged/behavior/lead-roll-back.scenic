#: description = "The car ahead stops gently and then rolls backwards toward the ego."
#: adversaries = ["car", "truck", "bus", "emergency-vehicle"]
#: origin = "NHTSA pre-crash typology: backing up; own code"
#: [slots]
#: actions = ["slow", "stop", "reverse"]
#: position = "ahead"

param OPT_ADV_DISTANCE = Range(28, 48)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_AHEAD = Range(30, 38)  #: [m] how far ahead of the ego it drives before it acts
param OPT_BRAKE = Range(0.2, 0.28)  #: [1] how hard it brakes
param OPT_STOP_TIME = Range(0.4, 0.9)  #: [s] how long it stands
param OPT_ADV_BACK_SPEED = Range(0.8, 2.4)  #: [m/s] how fast it rolls back

behavior AdvBehavior():
    do PaceOnPath(advTrajectory, ego, globalParameters.OPT_ADV_AHEAD, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and headway(egoRoute, ego, self) > 0.85 * globalParameters.OPT_ADV_AHEAD
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.05
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do ReverseStraight(globalParameters.OPT_ADV_BACK_SPEED) for 6 seconds
    do Halt()
