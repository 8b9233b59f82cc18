#: adversaries = ["car", "truck", "bus"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [variants]
#: junction-reverse  = { actions = ["stop", "reverse"], adv_distance = [26, 42], adv_speed = [6, 9], stop_distance = [0, 4.5], adv_back = [1.5, 4], adv_back_time = [1, 4] }
#: run-light-reverse = { actions = ["run-light", "stop", "reverse"], adv_distance = [30, 50], adv_speed = [6, 9], stop_distance = [-2.5, 2.5], adv_back = [1.5, 3.5], adv_back_time = [1.5, 4], position = "crossing", control = "signal", origin = "own code" }
#: [descriptions]
#: junction-reverse  = "The car enters the intersection, stops, and reverses."
#: run-light-reverse = "The crossing car runs the red light, stops, and backs up again."

param OPT_ADV_DISTANCE = Range$adv_distance  #: [m] how far the ego still is from where their ways meet when the adversary gets there
param OPT_ADV_SPEED = Range$adv_speed  #: [m/s] how fast it comes in
param OPT_STOP_DISTANCE = Range$stop_distance  #: [m] how far beyond where their ways meet it stops
param OPT_ADV_BACK = Range$adv_back  #: [m/s] how fast it backs up
param OPT_ADV_BACK_TIME = Range$adv_back_time  #: [s] for how long it backs up

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED  #: unless control
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED  #: if control
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory) until self.pose[3] < 0.05
    do Halt() for 0.5 seconds
    do ReverseStraight(globalParameters.OPT_ADV_BACK) for globalParameters.OPT_ADV_BACK_TIME seconds
    do Halt()
