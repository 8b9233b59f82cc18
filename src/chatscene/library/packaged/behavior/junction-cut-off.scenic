#: description = "The vehicle cuts off the ego vehicle at the intersection and slows in front of it."
#: adversaries = ["car", "motorcycle"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["cut-in"]
#: position = "crossing"

param OPT_ADV_DISTANCE = Range(12, 48)  #: [m] how far the ego still is from where their ways meet when it sets off
param OPT_ADV_SPEED = Range(6, 11)  #: [m/s] how fast it comes in
param OPT_SLOW_SPEED = Range(1, 5)  #: [m/s] how fast it goes on in front of the ego

advTurn = ("straight", "right-turn", "left-turn")

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 3.5
    do DrivePath(egoRoute, globalParameters.OPT_SLOW_SPEED)
