#: description = "The crossing car stops at the line, waits, and pulls out in front of the ego at full throttle."
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["hesitate", "accelerate"]
#: position = "crossing"

param OPT_ADV_DISTANCE = Range(12, 45)  #: [m] how far the ego still is from where their ways meet when it accelerates
param OPT_ADV_SPEED = Range(5, 9)  #: [m/s] how fast it comes to the line
param OPT_THROTTLE = Range(0.5, 1)  #: [1] how far the pedal is pressed

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until self.pose[3] > 1 and distanceLeft(advTrajectory, self, advTrajectory.entry) < 1.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until self.pose[3] < 0.05
    do Halt() for 0.4 seconds
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, 10)
