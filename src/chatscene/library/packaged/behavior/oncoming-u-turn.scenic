#: description = "The oncoming car makes a U-turn in front of the ego."
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "u-turn"]
#: position = "oncoming"
#: maneuver = "straight"
#: leader = false

param OPT_ADV_SPEED = Range(4, 6)  #: [m/s] how fast it drives
param OPT_ADV_DISTANCE = Range(22, 42)  #: [m] distance to the ego at which it turns round

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do TurnOff(2.9, globalParameters.OPT_ADV_SPEED, 3.5)
    do DrivePath(egoRoute, globalParameters.OPT_ADV_SPEED)
