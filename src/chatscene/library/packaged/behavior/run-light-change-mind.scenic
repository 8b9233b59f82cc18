#: description = "The crossing car brakes for the red light at the last moment, then changes its mind and accelerates through."
#: adversaries = ["car", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "brake", "accelerate"]
#: position = "crossing"
#: control = "signal"

param OPT_ADV_DISTANCE = Range(18, 50)  #: [m] how far the ego still is from where their ways meet when it sets off
param OPT_ADV_SPEED = Range(6, 10)  #: [m/s] how fast it comes in
param OPT_BRAKE = Range(0.5, 1)  #: [1] how hard it brakes
param OPT_THROTTLE = Range(0.6, 1)  #: [1] how far the pedal is pressed

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until self.pose[3] > 4.5 and distanceLeft(advTrajectory, self, advTrajectory.entry) < 2
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 2
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE)
