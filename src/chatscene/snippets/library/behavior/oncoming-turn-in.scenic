#: description = "The oncoming car suddenly turns into the ego's path without signalling."
#: rephrasings = [
#:   "A vehicle approaching from ahead cuts across in front of the ego.",
#:   "The opposing driver turns off through the ego's lane with no indicator.",
#:   "The adversary, facing the ego, swings left right over its way.",
#:   "An oncoming vehicle makes an abrupt turn into the road space of the ego.",
#:   "The car coming the other way crosses the centre line and stays in the ego's path.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "ego"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "cut-in"]
#: position = "oncoming"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 8.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 32.0
#: unit = "m"
#: meaning = "distance to the ego at which it turns"
#: [[parameters]]
#: name = "OPT_ADV_ANGLE"
#: low = 0.5
#: high = 1.2
#: unit = "rad"
#: meaning = "how sharply it turns"

param OPT_ADV_SPEED = Range(4, 8)
param OPT_ADV_DISTANCE = Range(12, 32)
param OPT_ADV_ANGLE = Range(0.5, 1.2)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE)
