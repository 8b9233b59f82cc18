#: description = "The oncoming car unexpectedly swerves into the ego's lane."
#: rephrasings = [
#:   "A driver coming the other way veers across the centre line.",
#:   "The approaching vehicle jerks over in front of the ego.",
#:   "Opposing traffic suddenly leaves its line and heads into the ego's side.",
#:   "The adversary from ahead lurches sideways toward the ego.",
#:   "The car driving toward the ego yanks the wheel over.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "swerve"]
#: position = "oncoming"
#: blocker = false
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 40.0
#: unit = "m"
#: meaning = "distance to the ego at which it swerves"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.5
#: high = 3.5
#: unit = "m"
#: meaning = "how far it swerves"

param OPT_ADV_SPEED = Range(4, 10)
param OPT_ADV_DISTANCE = Range(12, 40)
param OPT_SWERVE = Range(1.5, 3.5)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do SwerveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE)
