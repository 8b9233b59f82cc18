#: description = "The oncoming car starts to turn left across the ego's path, pauses, and then goes on."
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "Euro NCAP car-to-car front turn across path; own code"
#: [slots]
#: actions = ["oncoming", "turn-left", "hesitate"]
#: position = "oncoming"
#: maneuver = "straight"

param OPT_ADV_DISTANCE = Range(10, 30)  #: [m] how far the ego still is from where their ways meet when the adversary gets there
param OPT_ADV_SPEED = Range(5, 8)  #: [m/s] how fast it drives
param OPT_STOP_DISTANCE = Range(-1, 3)  #: [m] how far beyond where their ways meet it pauses
param OPT_STOP_TIME = Range(0.4, 1)  #: [s] how long it pauses

advTurn = "left-turn"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 8.5 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory) until self.pose[3] < 0.05
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
