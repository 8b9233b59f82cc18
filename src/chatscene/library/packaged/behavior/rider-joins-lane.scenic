#: description = "The cyclist swings into the ego's lane from the side and rides on slowly ahead of it."
#: adversaries = ["bicycle", "motorcycle"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cut-in", "slow"]

param OPT_ADV_SPEED = Range(1.5, 3.8)  #: [m/s] how fast it rides
param OPT_ADV_DISTANCE = Range(10, 40)  #: [m] how far the ego still has to go when it starts

behavior AdvBehavior():
    # Earlier where it has farther to go, or on a wide road it would pass behind the ego.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 2.5
    do DrivePath(egoRoute, globalParameters.OPT_ADV_SPEED)
