#: description = "The oncoming car suddenly turns into the ego's path without signalling."
#: rephrasings = [
#:   "A vehicle approaching from ahead cuts across in front of the ego.",
#:   "The opposing driver turns off through the ego's lane with no indicator.",
#:   "The adversary, facing the ego, swings left right over its way.",
#:   "An oncoming vehicle makes an abrupt turn into the road space of the ego.",
#:   "The car coming the other way crosses the centre line and stays in the ego's path.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "cut-in"]
#: position = "oncoming"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far before the middle of its way the ego is when the adversary sets off"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 12.0
#: high = 28.0
#: unit = "m"
#: meaning = "how far beyond that middle it turns"
#: [[parameters]]
#: name = "OPT_ADV_ANGLE"
#: low = 0.5
#: high = 1.1
#: unit = "rad"
#: meaning = "how sharply it turns"

param OPT_ADV_SPEED = Range(5, 9)
param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_REACH = Range(12, 28)
param OPT_ADV_ANGLE = Range(0.5, 1.1)

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(egoRoute, self, egoRoute.eventAt) > -globalParameters.OPT_ADV_REACH
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE) until abs(offsetFrom(ownLane(egoRoute), self)) < 1.5
    do Halt()
