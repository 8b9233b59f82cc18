#: description = "The car stays level with the ego and then squeezes over into its lane."
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "NHTSA pre-crash typology: changing lanes, same direction; own code"
#: [slots]
#: actions = ["pace", "cut-in"]
#: maneuver = "straight"
#: leader = false

param OPT_ADV_DISTANCE = Range(0, 32)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_AHEAD = Range(-4, 4)  #: [m] how far its rear is ahead of the ego's front before it moves over

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, min(7, globalParameters.OPT_ADV_AHEAD + (ego.length + self.length) / 2), 16, 1.5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and abs(headway(advLane, ego, self)) < 8
    do PaceOnPath(advLane, ego, min(7, globalParameters.OPT_ADV_AHEAD + (ego.length + self.length) / 2), 16, 1.5) for 1.5 seconds
    do PaceOnPath(egoRoute, ego, globalParameters.OPT_ADV_AHEAD + (ego.length + self.length) / 2, 16, 2.5)
