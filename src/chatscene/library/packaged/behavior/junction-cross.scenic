#: description = "The crossing car drives straight through the intersection in front of the ego."
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["follow"]

param OPT_ADV_DISTANCE = Range(12, 48)  #: [m] how far the ego still is from where their ways meet when it sets off
param OPT_ADV_SPEED = Range(5, 12)  #: [m/s] how fast it crosses

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
