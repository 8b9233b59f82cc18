#: description = "The car ahead stops gently and then rolls backwards toward the ego."
#: adversaries = ["car", "truck", "bus", "emergency-vehicle"]
#: origin = "NHTSA pre-crash typology: backing up; own code"
#: [slots]
#: actions = ["slow", "stop", "reverse"]
#: position = "ahead"

param OPT_ADV_DISTANCE = Range(10, 35)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_BRAKE = Range(0.14, 0.22)  #: [1] how hard it brakes
param OPT_STOP_TIME = Range(0.5, 1.5)  #: [s] how long it stands
param OPT_ADV_BACK_SPEED = Range(0.8, 2.4)  #: [m/s] how fast it rolls back

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.05
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do ReverseStraight(globalParameters.OPT_ADV_BACK_SPEED) for 6 seconds
    do Halt()
