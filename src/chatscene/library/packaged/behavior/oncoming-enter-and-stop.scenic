#: description = "The oncoming pedestrian comes along the road edge, enters the lane without warning and suddenly stops."
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "stop"]
#: position = "oncoming"

param OPT_ADV_SPEED = Range(2, 4)  #: [m/s] how fast it goes
param OPT_ADV_DISTANCE = Range(10, 28)  #: [m] distance to the ego at which it enters the lane
param OPT_ADV_ANGLE = Range(0.6, 1)  #: [rad] how sharply it turns into the lane
param OPT_STOP_DISTANCE = Range(0, 1)  #: [m] how far from the ego's line it comes to rest

# It faces against the ego's direction.
advFacing = 3.14159

behavior AdvBehavior():
    do Halt() until gap(self, ego) < 2 * globalParameters.OPT_ADV_DISTANCE + 6 * max(0, abs(offsetFrom(egoRoute, self)) - 4) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE + 6 * max(0, abs(offsetFrom(egoRoute, self)) - 4) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE if offsetFrom(egoRoute, self) > 0 else -globalParameters.OPT_ADV_ANGLE) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt()
