#: description = "The oncoming car crawls against the traffic in the ego's lane."
#: adversaries = ["car", "truck", "bus"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "wrong-way", "slow"]
#: position = "oncoming"
#: maneuver = "straight"

param OPT_ADV_SPEED = Range(1.5, 3.5)  #: [m/s] how fast it drives
param OPT_ADV_OFFSET = Range(0, 3)  #: [m] how far toward its own side it keeps when it meets the ego

behavior AdvBehavior():
    do DrivePath(advTrajectory, 8) until gap(self, ego) < 75
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 1 and gap(self, ego) < 30
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED, -globalParameters.OPT_ADV_OFFSET)
