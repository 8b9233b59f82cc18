#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"]
#: origin = "Euro NCAP car-to-car front turn across path; own code"
#: [slots]
#: position = "oncoming"
#: maneuver = "straight"
#: [variants]
#: oncoming-turn-into-drive       = { actions = ["oncoming", "turn-left"], adv_speed = [4, 6.5], adv_distance = [12, 50] }
#: oncoming-turn-into-drive-creep = { actions = ["oncoming", "turn-left", "slow"], adv_speed = [1.8, 3.5], adv_distance = [12, 40], adversaries = ["car", "truck", "bus", "bicycle"], origin = "own code" }
#: [descriptions]
#: oncoming-turn-into-drive       = "The oncoming car turns left across the ego's lane into a driveway."
#: oncoming-turn-into-drive-creep = "The oncoming car turns left across the ego's lane into a driveway at walking pace."

param OPT_ADV_SPEED = Range$adv_speed  #: [m/s] how fast it drives
param OPT_ADV_DISTANCE = Range$adv_distance  #: [m] distance to the ego at which it turns

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do TurnOff(1.4, globalParameters.OPT_ADV_SPEED, 6)
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
