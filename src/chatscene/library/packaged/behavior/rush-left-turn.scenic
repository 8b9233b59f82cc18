#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: [variants]
#: turn-left-rush           = { actions = ["turn-left", "accelerate"], side = "right", position = "crossing", adv_distance = [12, 48], throttle = [0.3, 0.6] }
#: oncoming-turn-left-rush  = { actions = ["oncoming", "accelerate", "turn-left"], position = "oncoming", adv_distance = [12, 48], throttle = [0.3, 0.6], origin = "NHTSA pre-crash typology: left turn across path, opposite direction; own code" }
#: run-light-turn-left-rush = { actions = ["run-light", "turn-left", "accelerate"], side = "right", position = "crossing", adv_distance = [18, 52], throttle = [0.45, 0.8], control = "signal" }
#: [descriptions]
#: turn-left-rush           = "The crossing car launches into a left turn in front of the ego, gaining speed."
#: oncoming-turn-left-rush  = "The oncoming car accelerates into a left turn across the ego's path."
#: run-light-turn-left-rush = "The waiting car runs the red light and turns left with the throttle down."

param OPT_ADV_DISTANCE = Range$adv_distance  #: [m] how far the ego still is from where their ways meet when it accelerates
param OPT_THROTTLE = Range$throttle  #: [1] how far the pedal is pressed

advTurn = "left-turn"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE  #: unless control
    do BrakeOnPath(advTrajectory) until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE  #: if control
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, 9)
