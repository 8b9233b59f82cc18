#: description = "The oncoming cyclist suddenly swerves across the middle of the road into the ego's lane."
#: rephrasings = [
#:   "A bike that comes the other way veers over the centre line in front of the ego.",
#:   "The motorcyclist riding toward the ego drifts abruptly onto the ego's side of the road.",
#:   "Someone on two wheels, heading for the ego, lurches into its path.",
#:   "The rider on the wrong way swings over into our lane.",
#:   "An approaching two-wheeler leaves its half of the road and ends up before the ego.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["swerve", "oncoming"]
#: position = "oncoming"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 15.0
#: high = 40.0
#: unit = "m"
#: meaning = "distance to the ego at which it swerves"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 2.4
#: high = 3.8
#: unit = "m"
#: meaning = "how far it swerves to its left"

param OPT_ADV_SPEED = Range(4, 10)
param OPT_ADV_DISTANCE = Range(15, 40)
param OPT_SWERVE = Range(2.4, 3.8)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do SwerveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE)
