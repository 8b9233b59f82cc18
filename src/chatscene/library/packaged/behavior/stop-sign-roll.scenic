#: description = "The crossing car brakes for the stop line without quite stopping, and speeds up across."
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["brake", "accelerate"]
#: position = "crossing"

param OPT_ADV_DISTANCE = Range(15, 45)  #: [m] how far the ego still is from where their ways meet when it sets off
param OPT_ADV_SPEED = Range(6, 9)  #: [m/s] how fast it comes in
param OPT_SLOW_SPEED = Range(1.2, 2.4)  #: [m/s] to what speed it slows down at the line
param OPT_ADV_SPRINT = Range(6, 10)  #: [m/s] how fast it becomes

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until self.pose[3] > 4.5 and distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5
    do BrakeOnPath(advTrajectory, 0.6) until self.pose[3] < globalParameters.OPT_SLOW_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPRINT)
