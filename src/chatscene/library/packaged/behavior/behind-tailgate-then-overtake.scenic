#: description = "The car behind tailgates the ego, then pulls out and overtakes it."
#: adversaries = ["car", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["tailgate", "overtake"]
#: position = "behind"
#: place = "road"

param OPT_ADV_DISTANCE = Range(5, 30)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_GAP = Range(0.8, 4)  #: [m] how much room it leaves between its bumper and the ego's
param OPT_ADV_SPEED = Range(10, 14)  #: [m/s] how fast it overtakes

behavior AdvBehavior():
    do PaceOnPath(advTrajectory, ego, -(ego.length + self.length) / 2 - globalParameters.OPT_ADV_GAP, 12) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(extended(adjacentLane, 20), globalParameters.OPT_ADV_SPEED)
