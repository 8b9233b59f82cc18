#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [variants]
#: junction-hesitate  = { actions = ["hesitate"], adv_distance = [14, 36], adv_speed = [4, 8], stop_distance = [-3, 2], stop_time = [0.4, 1.5] }
#: run-light-hesitate = { actions = ["run-light", "hesitate"], adv_distance = [0, 22], adv_speed = [5, 8], stop_distance = [-5, 0], stop_time = [0.4, 1.5], position = "crossing", control = "signal", origin = "own code" }
#: [descriptions]
#: junction-hesitate  = "The car pulls into the intersection, hesitates, and drives on."
#: run-light-hesitate = "The crossing car runs the red light, pauses halfway, and then goes on."

param OPT_ADV_DISTANCE = Range$adv_distance  #: [m] how far the ego still is from where their ways meet when the adversary gets there
param OPT_ADV_SPEED = Range$adv_speed  #: [m/s] how fast it drives
param OPT_STOP_DISTANCE = Range$stop_distance  #: [m] how far beyond where their ways meet it pauses
param OPT_STOP_TIME = Range$stop_time  #: [s] how long it pauses

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED  #: unless control
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED  #: if control
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory) until self.pose[3] < 0.05
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
