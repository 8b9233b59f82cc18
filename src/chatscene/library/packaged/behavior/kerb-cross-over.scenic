#: description = "The parked car pulls out and drives straight across the road to the other side."
#: adversaries = ["car", "truck", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "pull-out", "turn-left"]
#: side = "right"
#: position = "kerb"

param OPT_ADV_DISTANCE = Range(8, 24)  #: [m] how far the ego still has to go to it when it moves off
param OPT_ADV_SPEED = Range(2.5, 4.5)  #: [m/s] how fast it crosses

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3) for 0.3 seconds
    do TurnOff(1.2, globalParameters.OPT_ADV_SPEED)
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for 5 seconds
    do Halt()
