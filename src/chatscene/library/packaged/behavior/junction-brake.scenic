#: description = "The car enters the intersection and suddenly brakes."
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["brake"]

param OPT_ADV_DISTANCE = Range(12, 48)  #: [m] how far the ego still is from where their ways meet when it sets off
param OPT_ADV_SPEED = Range(6, 11)  #: [m/s] how fast it approaches
param OPT_BRAKE = Range(0.4, 1)  #: [1] how hard it brakes
param OPT_BRAKE_DISTANCE = Range(0, 8)  #: [m] how far before the place where their ways meet it brakes

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < globalParameters.OPT_BRAKE_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
