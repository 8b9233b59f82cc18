#: description = "The oncoming car overtakes in the ego's lane and swerves back to its own side very late."
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "wrong-way", "swerve"]
#: position = "oncoming"
#: maneuver = "straight"

param OPT_ADV_SPEED = Range(6, 11)  #: [m/s] how fast it drives
param OPT_ADV_DISTANCE = Range(8, 26)  #: [m] distance to the ego at which it goes back to its own lane

behavior AdvBehavior():
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 0.8 and gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
