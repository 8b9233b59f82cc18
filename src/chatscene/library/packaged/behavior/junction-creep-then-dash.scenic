#: description = "The car noses slowly into the intersection, then dashes across."
#: adversaries = ["car", "truck", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["hesitate", "accelerate"]

param OPT_ADV_DISTANCE = Range(0, 20)  #: [m] how far the ego still is from where their ways meet when the adversary gets there
param OPT_SLOW_SPEED = Range(1.5, 3)  #: [m/s] how fast it noses out
param OPT_STOP_DISTANCE = Range(-7, -3.5)  #: [m] how far beyond where their ways meet it pauses
param OPT_STOP_TIME = Range(0.3, 1)  #: [s] how long it pauses before it dashes
param OPT_THROTTLE = Range(0.7, 1)  #: [1] how far the pedal is pressed

advTurn = "straight"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advMeeting) < 12 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_SLOW_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED) until self.pose[3] > 1 and distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory) until self.pose[3] < 0.05
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, 10)
