#: description = "The car enters the intersection and suddenly swerves to the right."
#: rephrasings = [
#:   "A vehicle coming in jerks over to its right-hand side.",
#:   "The adversary leaves its line through the junction with an abrupt lurch to the right.",
#:   "The other driver pulls sharply right toward the ego's lane.",
#:   "Midway over the crossroads the car veers off rightward.",
#:   "The incoming car dodges to the right without warning.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenario right-turn; own code"
#: [slots]
#: actions = ["swerve"]
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
#: name = "OPT_SWERVE"
#: low = 1.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far it swerves"
#: [[parameters]]
#: name = "OPT_SWERVE_DISTANCE"
#: low = 0.0
#: high = 8.0
#: unit = "m"
#: meaning = "how far before the place where their ways meet it swerves"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_SPEED = Range(5, 10)
param OPT_SWERVE = Range(1, 3)
param OPT_SWERVE_DISTANCE = Range(0, 8)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < globalParameters.OPT_SWERVE_DISTANCE
    do SwerveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, -globalParameters.OPT_SWERVE)
