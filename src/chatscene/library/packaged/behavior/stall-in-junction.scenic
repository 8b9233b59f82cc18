#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "own code"
#: [variants]
#: junction-stall  = { actions = ["slow", "stop"], adv_distance = [10, 30], adv_speed = [4.5, 7], brake = [0.08, 0.15] }
#: run-light-stall = { actions = ["run-light", "slow", "stop"], adv_distance = [0, 18], adv_speed = [5, 7.5], brake = [0.08, 0.15], position = "crossing", control = "signal" }
#: [descriptions]
#: junction-stall  = "The car loses its drive in the intersection and rolls slowly to a stop."
#: run-light-stall = "The crossing car runs the red light, loses its drive, and rolls to a stop in the junction."

param OPT_ADV_DISTANCE = Range$adv_distance  #: [m] how far the ego still is from where their ways meet when the adversary gets there
param OPT_ADV_SPEED = Range$adv_speed  #: [m/s] how fast it comes in
param OPT_BRAKE = Range$brake  #: [1] how fast it loses its way

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED  #: unless control
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED  #: if control
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) / globalParameters.OPT_BRAKE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
