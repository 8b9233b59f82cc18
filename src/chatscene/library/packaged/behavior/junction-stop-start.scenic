#: description = "The car crosses the intersection in small jerks, stopping again and again."
#: adversaries = ["car", "truck", "bus"]
#: origin = "own code"
#: [slots]
#: actions = ["slow", "hesitate"]

param OPT_ADV_DISTANCE = Range(5, 25)  #: [m] how far the ego still is from where their ways meet when the adversary gets there
param OPT_SLOW_SPEED = Range(2, 3.5)  #: [m/s] how fast it creeps
param OPT_ADV_PERIOD = Range(1, 2)  #: [s] how long it rolls each time
param OPT_STOP_TIME = Range(0.6, 1)  #: [s] how long it stands in between

advTurn = "straight"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advMeeting) < 10 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_SLOW_SPEED
    while True:
        do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED) for globalParameters.OPT_ADV_PERIOD seconds
        do BrakeOnPath(advTrajectory) for globalParameters.OPT_STOP_TIME seconds
