#: description = "The oncoming car flashes past at high speed while the ego goes around the obstacle."
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "fast"]
#: position = "oncoming"
#: maneuver = "bypass"

param OPT_ADV_SPEED = Range(12, 16)  #: [m/s] how fast it drives
param OPT_ADV_DISTANCE = Range(15, 50)  #: [m] how far before the middle of its way around the ego is when the adversary sets off

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, 1, 0, globalParameters.OPT_ADV_SPEED)
