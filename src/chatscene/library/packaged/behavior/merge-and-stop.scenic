#: adversaries = ["car", "truck", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: position = "crossing"
#: [variants]
#: junction-cut-off-stop = { actions = ["cut-in", "brake", "stop"], adv_distance = [16, 36], adv_speed = [6, 9], stop_time = [0.4, 1.2], turn = ["straight", "right-turn", "left-turn"], aside = 3.5 }
#: turn-right-merge-stop = { actions = ["turn-right", "brake", "stop"], adv_distance = [26, 46], adv_speed = [6, 8], stop_time = [1.2, 2.2], turn = ["straight", "right-turn"], aside = 6, side = "right", maneuver = "straight", adversaries = ["car", "truck", "bus", "motorcycle"] }
#: [descriptions]
#: junction-cut-off-stop = "The car turns into the ego's lane, brakes hard, and stops."
#: turn-right-merge-stop = "The car turns right into the ego's lane and brakes to a stop."

param OPT_ADV_DISTANCE = Range$adv_distance  #: [m] how far the ego still is from where their ways meet when the adversary gets there
param OPT_ADV_SPEED = Range$adv_speed  #: [m/s] how fast it comes in
param OPT_STOP_TIME = Range$stop_time  #: [s] how long it drives in the ego's lane before it brakes

advTurn = $turn

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < $aside
    do DrivePath(egoRoute, globalParameters.OPT_ADV_SPEED) for globalParameters.OPT_STOP_TIME seconds
    do BrakeOnPath(egoRoute)
