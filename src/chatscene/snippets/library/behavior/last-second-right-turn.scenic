#: description = "The car approaches at a normal speed and makes a last-second right turn."
#: rephrasings = [
#:   "A vehicle comes on as if to go straight and abruptly swings to the right.",
#:   "The adversary decides at the final moment to turn right.",
#:   "The other driver yanks the wheel to the right in the middle of the junction.",
#:   "Late and without signalling, the car turns off to its right.",
#:   "The approaching vehicle suddenly hooks right into the road the ego is taking.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["turn-right"]
#: maneuver = "left-turn"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it approaches"
#: [[parameters]]
#: name = "OPT_SWERVE_DISTANCE"
#: low = 2.0
#: high = 14.0
#: unit = "m"
#: meaning = "how far before the place where their ways meet it turns"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_SPEED = Range(5, 10)
param OPT_SWERVE_DISTANCE = Range(2, 14)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < globalParameters.OPT_SWERVE_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED, -1.5708)
