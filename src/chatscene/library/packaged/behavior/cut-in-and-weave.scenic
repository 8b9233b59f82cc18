#: description = "The car cuts in front of the ego and weaves from side to side there."
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["cut-in", "weave"]
#: maneuver = "straight"
#: leader = false

param OPT_ADV_DISTANCE = Range(10, 38)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_AHEAD = Range(4, 10)  #: [m] how far its rear is ahead of the ego's front before it moves over
param OPT_ADV_SPEED = Range(2.5, 5)  #: [m/s] how fast it drives
param OPT_ADV_AMPLITUDE = Range(0.8, 1.3)  #: [m] how far it swings to either side

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD + (ego.length + self.length) / 2, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(egoRoute, 6) until abs(offsetFrom(egoRoute, self)) < 1
    do WeaveOnPath(egoRoute, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, 3.2)
