#: description = "The oncoming car comes slowly along the ego's lane the wrong way and stops."
#: adversaries = ["car", "truck", "bus", "bicycle"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "wrong-way", "slow", "stop"]
#: position = "oncoming"
#: maneuver = "straight"

param OPT_ADV_SPEED = Range(2, 3.6)  #: [m/s] how fast it drives
param OPT_ADV_DISTANCE = Range(8, 25)  #: [m] distance to the ego at which it stops

behavior AdvBehavior():
    do DrivePath(advTrajectory, 8) until gap(self, ego) < 60
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 0.8 and gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(against(egoRoute), 0.3)
