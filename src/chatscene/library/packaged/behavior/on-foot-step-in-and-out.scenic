#: description = "The oncoming pedestrian strays into the ego's lane and withdraws to the edge again."
#: adversaries = ["pedestrian"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "turn-back"]
#: position = "oncoming"
#: maneuver = "straight"
#: place = "road"

param OPT_ADV_SPEED = Range(2, 4)  #: [m/s] how fast it goes
param OPT_ADV_DISTANCE = Range(20, 36)  #: [m] distance to the ego at which it enters the lane
param OPT_ADV_REACH = Range(0.4, 1.6)  #: [m] how far from the ego's line it withdraws

# It faces against the ego's direction.
advFacing = 3.14159

behavior AdvBehavior():
    do Halt() until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE + 2 * abs(offsetFrom(egoRoute, self))
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 1) until restsWithin(egoRoute, self, globalParameters.OPT_ADV_REACH)
    do MoveAhead(globalParameters.OPT_ADV_SPEED, -2) until abs(offsetFrom(egoRoute, self)) > 3
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 1)
