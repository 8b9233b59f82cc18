#: description = "The oncoming pedestrian sways along the road toward the ego, now beside the lane, now in it."
#: adversaries = ["pedestrian"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "weave"]
#: position = "oncoming"
#: place = "road"

param OPT_ADV_SPEED = Range(1.8, 3)  #: [m/s] how fast it goes
param OPT_ADV_DISTANCE = Range(34, 48)  #: [m] distance to the ego at which it sets off
param OPT_ADV_ANGLE = Range(0.6, 1)  #: [rad] how far each leg slants
param OPT_ADV_PERIOD = Range(1.2, 1.8)  #: [s] how long a leg takes

# It faces against the ego's direction.
advFacing = 3.14159

behavior AdvBehavior():
    do Halt() until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(3, 1) until abs(offsetFrom(egoRoute, self)) < 2
    do MoveAhead(globalParameters.OPT_ADV_SPEED, -1 - globalParameters.OPT_ADV_ANGLE) for globalParameters.OPT_ADV_PERIOD seconds
    while True:
        do MoveAhead(globalParameters.OPT_ADV_SPEED, 2 * globalParameters.OPT_ADV_ANGLE) for globalParameters.OPT_ADV_PERIOD seconds
        do MoveAhead(globalParameters.OPT_ADV_SPEED, -2 * globalParameters.OPT_ADV_ANGLE) for globalParameters.OPT_ADV_PERIOD seconds
