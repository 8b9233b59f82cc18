#: description = "The oncoming rider turns left across the ego's lane."
#: adversaries = ["bicycle", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "turn-left", "cross"]
#: position = "oncoming"
#: maneuver = "straight"
#: place = "road"

param OPT_ADV_SPEED = Range(3.5, 6)  #: [m/s] how fast it rides
param OPT_ADV_DISTANCE = Range(11, 22)  #: [m] distance to the ego at which it turns
param OPT_TURN_RADIUS = Range(2.5, 4)  #: [m] the radius of its turn

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do TurnOff(1.5, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_TURN_RADIUS)
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
