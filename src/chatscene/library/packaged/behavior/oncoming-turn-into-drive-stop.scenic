#: description = "The oncoming car turns left across the ego's lane and stops broadside."
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "turn-left", "stop"]
#: position = "oncoming"
#: maneuver = "straight"

param OPT_ADV_SPEED = Range(4, 6)  #: [m/s] how fast it drives
param OPT_ADV_DISTANCE = Range(18, 45)  #: [m] distance to the ego at which it turns
param OPT_STOP_TIME = Range(0, 0.5)  #: [s] how long it goes on before it stops across the lane

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do TurnOff(1.1, globalParameters.OPT_ADV_SPEED, 5)
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for globalParameters.OPT_STOP_TIME seconds
    do Halt()
