#: description = "The rider shoots out from the side and races across the road, faster and faster."
#: adversaries = ["bicycle", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "accelerate", "follow"]

param OPT_ADV_SPEED = Range(7, 12)  #: [m/s] how fast it wants to ride
param OPT_ADV_DISTANCE = Range(-2, 20)  #: [m] how far the ego still has to go when it starts to move

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
