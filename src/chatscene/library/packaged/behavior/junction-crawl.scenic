#: description = "The car blocks multiple lanes by driving extremely slowly through the intersection."
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["slow"]

param OPT_ADV_DISTANCE = Range(8, 30)  #: [m] how far the ego still is from where their ways meet when it sets off
param OPT_ADV_SPEED = Range(5, 9)  #: [m/s] how fast it comes in
param OPT_SLOW_DISTANCE = Range(-2, 6)  #: [m] how far before the place where their ways meet it slows down
param OPT_SLOW_SPEED = Range(0.6, 2.2)  #: [m/s] how fast it crosses then

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < globalParameters.OPT_SLOW_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED)
