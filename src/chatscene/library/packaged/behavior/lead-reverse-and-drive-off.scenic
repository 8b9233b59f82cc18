#: description = "The car ahead stops hard, reverses a little and then drives off forward."
#: adversaries = ["car", "truck", "bus", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["brake", "stop", "reverse", "accelerate"]
#: position = "ahead"

param OPT_ADV_DISTANCE = Range(-15, 20)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_BRAKE = Range(0.5, 1)  #: [1] how hard it brakes
param OPT_ADV_BACK_SPEED = Range(1, 3)  #: [m/s] how fast it backs up
param OPT_ADV_BACK_TIME = Range(1, 3)  #: [s] for how long it backs up

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.05
    do Halt() for 0.5 seconds
    do ReverseStraight(globalParameters.OPT_ADV_BACK_SPEED) for globalParameters.OPT_ADV_BACK_TIME seconds
    do DrivePath(advTrajectory, 8)
