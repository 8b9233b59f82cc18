#: description = "The vehicle cuts off the ego vehicle at the intersection and slows in front of it."
#: rephrasings = [
#:   "A car forces its way before the ego and stays there.",
#:   "The adversary dives in ahead, leaving the ego no room.",
#:   "The other driver barges into the ego's lane.",
#:   "Coming from the side, a vehicle takes the ego's way from it.",
#:   "The crossing car slots in right before the ego's bonnet.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: position = "crossing"
#: actions = ["cut-in"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 6.0
#: high = 11.0
#: unit = "m/s"
#: meaning = "how fast it comes in"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 1.0
#: high = 5.0
#: unit = "m/s"
#: meaning = "how fast it goes on in front of the ego"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_SPEED = Range(6, 11)
param OPT_SLOW_SPEED = Range(1, 5)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 3.5
    do DrivePath(egoRoute, globalParameters.OPT_SLOW_SPEED)
