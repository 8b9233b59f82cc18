#: description = "The car suddenly cuts in front of the ego and drives on."
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["cut-in", "change-lane"]
#: leader = false
#: blocker = false

param OPT_ADV_DISTANCE = Range(-15, 20)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_SPEED = Range(4, 9)  #: [m/s] how fast it drives then

behavior AdvBehavior():
    do KeepStation(advLane, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(ownLane(egoRoute), globalParameters.OPT_ADV_SPEED)
