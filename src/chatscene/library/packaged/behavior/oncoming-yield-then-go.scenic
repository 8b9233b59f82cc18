#: description = "The oncoming car brakes as if to let the ego turn, then accelerates."
#: adversaries = ["car", "truck", "bus"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "brake", "accelerate"]
#: position = "oncoming"
#: maneuver = "left-turn"

param OPT_ADV_DISTANCE = Range(10, 30)  #: [m] how far the ego still is from where their ways meet when the adversary gets there
param OPT_ADV_SPEED = Range(7, 10)  #: [m/s] how fast it comes in
param OPT_SLOW_SPEED = Range(1, 2)  #: [m/s] to what speed it slows down
param OPT_THROTTLE = Range(0.7, 1)  #: [1] how far the pedal is pressed

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until self.pose[3] > 5 and distanceLeft(advTrajectory, self, advTrajectory.entry) < 6
    do BrakeOnPath(advTrajectory, 0.7) until self.pose[3] < globalParameters.OPT_SLOW_SPEED
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, 9)
