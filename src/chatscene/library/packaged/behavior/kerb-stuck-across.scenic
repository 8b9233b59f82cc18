#: description = "The parked car swings out to turn round and gets stuck across the ego's lane."
#: adversaries = ["car", "truck", "bus", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "turn-left", "stop"]
#: side = "right"
#: position = "kerb"

param OPT_ADV_DISTANCE = Range(22, 38)  #: [m] how far the ego still has to go to it when it moves off
param OPT_ADV_TURN = Range(0.95, 1.2)  #: [rad] how far it turns to the left

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3) for 0.3 seconds
    do TurnOff(globalParameters.OPT_ADV_TURN, 3)
    do Halt()
