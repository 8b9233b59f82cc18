#: adversaries = ["car", "motorcycle", "bicycle"]
#: origin = "own code"
#: [variants]
#: turn-left-creep           = { actions = ["turn-left", "slow"], side = "right", position = "crossing", maneuver = "straight", adv_distance = [4, 18], slow_speed = [2.8, 3.9], turn = "left-turn" }
#: oncoming-turn-left-creep  = { actions = ["oncoming", "turn-left", "slow"], position = "oncoming", maneuver = "straight", adv_distance = [0, 15], slow_speed = [2.5, 3.8], turn = "left-turn", adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"] }
#: run-light-turn-left-creep = { actions = ["run-light", "turn-left", "slow"], side = "right", position = "crossing", maneuver = "straight", adv_distance = [0, 15], slow_speed = [2.3, 3.5], turn = "left-turn", control = "signal" }
#: run-light-creep           = { actions = ["run-light", "slow"], position = "crossing", adv_distance = [0, 15], slow_speed = [2, 3.6], turn = "straight", control = "signal", adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"] }
#: [descriptions]
#: turn-left-creep           = "The crossing car turns left in front of the ego at walking pace."
#: oncoming-turn-left-creep  = "The oncoming car turns left across the ego's path at walking pace."
#: run-light-turn-left-creep = "The crossing car runs the red light and turns left at walking pace."
#: run-light-creep           = "The crossing car creeps over the line on red and crosses at walking pace."

param OPT_ADV_DISTANCE = Range$adv_distance  #: [m] how far the ego still is from where their ways meet when the adversary gets there
param OPT_SLOW_SPEED = Range$slow_speed  #: [m/s] how fast it creeps across

advTurn = "$turn"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_SLOW_SPEED  #: unless control
    do BrakeOnPath(advTrajectory) until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_SLOW_SPEED  #: if control
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED)
