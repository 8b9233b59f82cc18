#: description = "The car ahead stops and abruptly reverses."
#: adversaries = ["car", "truck", "bus"]
#: origin = "base scenario right-turn; own code"
#: [slots]
#: actions = ["stop", "reverse"]

param OPT_ADV_DISTANCE = Range(-15, 20)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_BRAKE = Range(0.5, 1)  #: [1] how hard it brakes first
param OPT_ADV_SPEED = Range(1, 3.5)  #: [m/s] how fast it backs up
param OPT_ADV_BACK_TIME = Range(1, 4)  #: [s] for how long

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.05
    do Halt() for 0.5 seconds
    do ReverseStraight(globalParameters.OPT_ADV_SPEED) for globalParameters.OPT_ADV_BACK_TIME seconds
    do Halt()
