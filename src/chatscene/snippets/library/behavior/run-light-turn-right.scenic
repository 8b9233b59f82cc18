#: description = "The vehicle runs the red light and makes an abrupt right turn."
#: rephrasings = [
#:   "A car ignores the signal and hooks sharply to the right inside the junction.",
#:   "Jumping the lights, the adversary swings right in front of the ego.",
#:   "The other driver crosses on red and suddenly turns right.",
#:   "Against the red a vehicle enters and yanks the wheel rightward.",
#:   "The motorcyclist disregards the lights and cuts round to the right.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenario red-light-running; own code"
#: [slots]
#: actions = ["run-light", "turn-right"]
#: position = "crossing"
#: control = "signal"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 18.0
#: high = 42.0
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
#: low = 0.0
#: high = 8.0
#: unit = "m"
#: meaning = "how far before the place where their ways meet it turns"

param OPT_ADV_DISTANCE = Range(18, 42)
param OPT_ADV_SPEED = Range(5, 10)
param OPT_SWERVE_DISTANCE = Range(0, 8)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < globalParameters.OPT_SWERVE_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED, -1.5708)
