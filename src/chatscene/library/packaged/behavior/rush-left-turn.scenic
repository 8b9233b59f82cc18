#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: [variants]
#: turn-left-rush           = { actions = ["turn-left", "accelerate"], side = "right", position = "crossing", adv_distance = [8, 32], throttle = [0.45, 0.8] }
#: oncoming-turn-left-rush  = { actions = ["oncoming", "accelerate", "turn-left"], position = "oncoming", adv_distance = [8, 32], throttle = [0.45, 0.8], origin = "NHTSA pre-crash typology: left turn across path, opposite direction; own code" }
#: run-light-turn-left-rush = { actions = ["run-light", "turn-left", "accelerate"], side = "right", position = "crossing", adv_distance = [8, 32], throttle = [0.45, 0.8], control = "signal" }
#: [descriptions]
#: turn-left-rush           = "The crossing car launches into a left turn in front of the ego, gaining speed."
#: oncoming-turn-left-rush  = "The oncoming car accelerates into a left turn across the ego's path."
#: run-light-turn-left-rush = "The waiting car runs the red light and turns left with the throttle down."

param OPT_ADV_DISTANCE = Range$adv_distance  #: [m] how far the ego still is from where their ways meet when the adversary gets there
param OPT_THROTTLE = Range$throttle  #: [1] how far the pedal is pressed

advTurn = "left-turn"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / 6  #: unless control
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / 6  #: if control
    do DrivePath(advTrajectory, 7) until distanceLeft(advTrajectory, self, advTrajectory.entry) < -1
    do BrakeOnPath(advTrajectory, 0.5) until self.pose[3] < 3.5
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, 10)
