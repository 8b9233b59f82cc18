#: description = "The car turns left across the ego's way without yielding."
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["turn-left"]
#: maneuver = "straight"

param OPT_ADV_DISTANCE = Range(-4, 26)  #: [m] how far the ego still is from where their ways meet when it sets off
param OPT_ADV_SPEED = Range(4, 10)  #: [m/s] how fast it turns

advTurn = "left-turn"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, acrossMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
