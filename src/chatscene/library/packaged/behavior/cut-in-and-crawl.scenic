#: description = "The car moves over in front of the ego and then drives very slowly."
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "UN R157 cut-in; own code"
#: [slots]
#: actions = ["cut-in", "slow"]
#: maneuver = "straight"
#: leader = false

param OPT_ADV_DISTANCE = Range(-10, 25)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_AHEAD = Range(8, 16)  #: [m] how far its rear is ahead of the ego's front before it moves over
param OPT_ADV_SPEED = Range(1.8, 3.3)  #: [m/s] how fast it drives in the ego's lane

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD + (ego.length + self.length) / 2, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and headway(egoRoute, ego, self) > 0.8 * globalParameters.OPT_ADV_AHEAD + 3
    do DrivePath(egoRoute, globalParameters.OPT_ADV_SPEED)
