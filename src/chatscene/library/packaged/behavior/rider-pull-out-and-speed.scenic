#: description = "The rider pulls out from the roadside into the ego's lane and accelerates away along it."
#: adversaries = ["bicycle"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "accelerate"]
#: place = "road"

param OPT_ADV_SPEED = Range(4.5, 9)  #: [m/s] how fast it rides in the end
param OPT_ADV_DISTANCE = Range(3, 20)  #: [m] how far the ego still has to go when it starts to move

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    do MoveAhead(3.5) until abs(offsetFrom(egoRoute, self)) < 3
    do DrivePath(egoRoute, globalParameters.OPT_ADV_SPEED)
