#: description = "The car cuts into the ego's lane and at once goes back to where it came from."
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "NHTSA pre-crash typology: changing lanes; own code"
#: [slots]
#: actions = ["cut-in", "turn-back"]
#: maneuver = "straight"
#: leader = false

param OPT_ADV_DISTANCE = Range(-10, 25)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_AHEAD = Range(4, 12)  #: [m] how far its rear is ahead of the ego's front before it moves over
param OPT_ADV_SPEED = Range(5, 7)  #: [m/s] how fast it drives

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD + (ego.length + self.length) / 2, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and headway(egoRoute, ego, self) > 0.8 * globalParameters.OPT_ADV_AHEAD + 3
    do DrivePath(egoRoute, globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 0.8
    do DrivePath(advLane, globalParameters.OPT_ADV_SPEED)
