#: description = "The emergency vehicle closes up on the ego's bumper, pulls out and storms past."
#: adversaries = ["emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["tailgate", "overtake", "fast"]
#: position = "behind"
#: place = "road"

param OPT_ADV_DISTANCE = Range(15, 36)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_GAP = Range(0.8, 5)  #: [m] how much room it leaves between its bumper and the ego's

behavior AdvBehavior():
    do PaceOnPath(advTrajectory, ego, -(ego.length + self.length) / 2 - globalParameters.OPT_ADV_GAP, 16) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and headway(advTrajectory, self, ego) < (ego.length + self.length) / 2 + 6
    do PaceOnPath(advTrajectory, ego, -(ego.length + self.length) / 2 - globalParameters.OPT_ADV_GAP, 16) for 1.5 seconds
    do ThrottleOnPath(extended(adjacentLane, 20), 1, 0, 16)
