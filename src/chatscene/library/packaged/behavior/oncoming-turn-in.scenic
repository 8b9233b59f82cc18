#: description = "The oncoming car suddenly turns into the ego's path without signalling."
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "cut-in"]
#: position = "oncoming"
#: place = "road"

param OPT_ADV_SPEED = Range(5, 9)  #: [m/s] how fast it drives
param OPT_ADV_DISTANCE = Range(12, 48)  #: [m] how far before the middle of its way the ego is when the adversary sets off
param OPT_ADV_REACH = Range(15, 30)  #: [m] how far beyond that middle it turns
param OPT_ADV_ANGLE = Range(0.5, 1.1)  #: [rad] how sharply it turns

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(egoRoute, self, egoRoute.eventAt) > -globalParameters.OPT_ADV_REACH
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE) until abs(offsetFrom(ownLane(egoRoute), self)) < 1.5
    do Halt()
