#: description = "The car turns left across the ego's way and stops in the intersection."
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["turn-left", "stop"]
#: maneuver = "straight"

param OPT_ADV_DISTANCE = Range(20, 40)  #: [m] how far the ego still is from where their ways meet when it sets off
param OPT_ADV_SPEED = Range(5.5, 9)  #: [m/s] how fast it turns
param OPT_STOP_DISTANCE = Range(4, 7.5)  #: [m] how far beyond where their ways meet it comes to rest

advTurn = "left-turn"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, acrossMeeting) < globalParameters.OPT_ADV_DISTANCE + 8 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory)
