#: description = "The emergency vehicle accelerates hard through the red light with lights and siren on."
#: adversaries = ["emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "accelerate", "fast"]
#: position = "crossing"
#: control = "signal"

param OPT_ADV_DISTANCE = Range(8, 32)  #: [m] how far the ego still is from where their ways meet when the adversary gets there
param OPT_ADV_SPEED = Range(12, 17)  #: [m/s] how fast it becomes
param OPT_THROTTLE = Range(0.7, 1)  #: [1] how far the pedal is pressed

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / 9
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 2
    do BrakeOnPath(advTrajectory, 0.5) until self.pose[3] < 6
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, globalParameters.OPT_ADV_SPEED)
