#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "base scenario red-light-running; own code"
#: [slots]
#: position = "crossing"
#: control = "signal"
#: [variants]
#: run-light-turn-left  = { actions = ["run-light", "turn-left"], adv_distance = [18, 42], adv_speed = [5, 10], swerve_distance = [0, 5], angle = 1.5708 }
#: run-light-turn-right = { actions = ["run-light", "turn-right"], adv_distance = [18, 42], adv_speed = [5, 10], swerve_distance = [0, 8], angle = -1.5708 }
#: [descriptions]
#: run-light-turn-left  = "The vehicle runs the red light and makes an abrupt left turn."
#: run-light-turn-right = "The vehicle runs the red light and makes an abrupt right turn."

param OPT_ADV_DISTANCE = Range$adv_distance  #: [m] how far the ego still is from where their ways meet when it sets off
param OPT_ADV_SPEED = Range$adv_speed  #: [m/s] how fast it drives
param OPT_SWERVE_DISTANCE = Range$swerve_distance  #: [m] how far before the place where their ways meet it turns

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    # Where no way goes straight on, it leaves its way before that bends.
    start = self.pose[2]
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < globalParameters.OPT_SWERVE_DISTANCE or abs(self.pose[2] - start) > 0.15
    do MoveAhead(globalParameters.OPT_ADV_SPEED, $angle)
