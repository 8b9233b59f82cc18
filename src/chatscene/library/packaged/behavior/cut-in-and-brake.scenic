#: description = "The car cuts in right before the ego and brakes."
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["cut-in", "brake"]
#: leader = false
#: blocker = false

param OPT_ADV_DISTANCE = Range(-15, 20)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_AHEAD = Range(9, 18)  #: [m] how far ahead of the ego it drives before it moves over
param OPT_ADV_SPEED = Range(5, 9)  #: [m/s] how fast it drives while it cuts in
param OPT_BRAKE = Range(0.4, 1)  #: [1] how hard it brakes

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and headway(egoRoute, ego, self) > 0.8 * globalParameters.OPT_ADV_AHEAD
    do DrivePath(ownLane(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(ownLane(egoRoute), self)) < 1
    do BrakeOnPath(ownLane(egoRoute), globalParameters.OPT_BRAKE)
