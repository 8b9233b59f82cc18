#: description = "The oncoming car races against the traffic in the ego's lane."
#: adversaries = ["car", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "wrong-way", "fast"]
#: position = "oncoming"
#: maneuver = "straight"

param OPT_ADV_SPEED = Range(12.5, 17)  #: [m/s] how fast it drives
param OPT_ADV_DISTANCE = Range(65, 95)  #: [m] distance to the ego at which it comes over into the ego's lane
param OPT_ADV_OFFSET = Range(0, 3)  #: [m] how far toward its own side it keeps when it meets the ego

behavior AdvBehavior():
    do ThrottleOnPath(advTrajectory, 1, 0, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(against(egoRoute), 1, 0, globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 1 and gap(self, ego) < 50
    do ThrottleOnPath(against(egoRoute), 1, -globalParameters.OPT_ADV_OFFSET, globalParameters.OPT_ADV_SPEED)
