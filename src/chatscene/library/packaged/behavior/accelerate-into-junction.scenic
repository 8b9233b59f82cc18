#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [variants]
#: junction-accelerate  = { actions = ["accelerate"], adv_distance = [12, 48], adv_speed = [0.8, 2.5], throttle = [0.5, 1] }
#: run-light-accelerate = { actions = ["run-light", "accelerate"], adv_distance = [8, 32], adv_speed = [2, 4], throttle = [0.5, 1], position = "crossing", control = "signal", origin = "base scenario red-light-running; own code" }
#: [descriptions]
#: junction-accelerate  = "The car suddenly accelerates and enters the intersection."
#: run-light-accelerate = "The crossing vehicle runs the red light and unexpectedly accelerates."

param OPT_ADV_DISTANCE = Range$adv_distance  #: [m] how far the ego still is from where their ways meet when it accelerates
param OPT_ADV_SPEED = Range$adv_speed  #: [m/s] how fast it approaches
param OPT_THROTTLE = Range$throttle  #: [1] how far the pedal is pressed

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE  #: unless control
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / 6  #: if control
    do DrivePath(advTrajectory, 7) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 1  #: if control
    do BrakeOnPath(advTrajectory, 0.5) until self.pose[3] < globalParameters.OPT_ADV_SPEED  #: if control
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE)
