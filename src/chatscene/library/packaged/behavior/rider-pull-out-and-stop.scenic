#: description = "The rider pulls out from the roadside into the ego's lane, rides a few metres along it and brakes to a stop."
#: adversaries = ["bicycle", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "brake", "stop"]
#: place = "road"

param OPT_ADV_SPEED = Range(3, 5.5)  #: [m/s] how fast it rides
param OPT_ADV_DISTANCE = Range(6, 26)  #: [m] how far the ego still has to go when it starts to move
param OPT_ADV_TIME = Range(1.5, 3.5)  #: [s] how long it rides along the lane before it brakes
param OPT_BRAKE = Range(0.6, 1)  #: [1] how hard it brakes

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 3
    do DrivePath(egoRoute, globalParameters.OPT_ADV_SPEED) for globalParameters.OPT_ADV_TIME seconds
    do BrakeOnPath(egoRoute, globalParameters.OPT_BRAKE)
