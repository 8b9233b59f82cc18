#: description = "The vehicle runs the red light and makes an abrupt right turn."
#: rephrasings = [
#:   "A car ignores the signal and hooks sharply to the right inside the junction.",
#:   "Jumping the lights, the adversary swings right in front of the ego.",
#:   "The other driver crosses on red and suddenly turns right.",
#:   "Against the red a vehicle enters and yanks the wheel rightward.",
#:   "The motorcyclist disregards the lights and cuts round to the right.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenario red-light-running; own code"
#: [slots]
#: actions = ["run-light", "turn-right"]
#: control = "signal"
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
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_SWERVE_DISTANCE"
#: low = 2.0
#: high = 10.0
#: unit = "m"
#: meaning = "how far from the ego's line it turns"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_SPEED = Range(5, 10)
param OPT_SWERVE_DISTANCE = Range(2, 10)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_SWERVE_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED, -1.5708)
