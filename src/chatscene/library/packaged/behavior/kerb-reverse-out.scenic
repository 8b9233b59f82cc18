#: description = "The parked car backs out of its parking space into the ego's lane."
#: adversaries = ["car", "truck", "emergency-vehicle"]
#: origin = "NHTSA pre-crash typology: backing up into another vehicle; own code"
#: [slots]
#: actions = ["reverse"]
#: side = "right"
#: position = "kerb"

param OPT_ADV_DISTANCE = Range(8, 34)  #: [m] how far the ego still has to go to it when it moves off
param OPT_ADV_BACK_SPEED = Range(2, 3.8)  #: [m/s] how fast it backs up
param OPT_STOP_OFFSET = Range(1, 2.4)  #: [m] how far from the middle of the lane it stops

behavior AdvBehavior():
    start = progressOn(advKerb, self)[0]
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do ReverseTurning(globalParameters.OPT_ADV_BACK_SPEED, -0.75 if offsetFrom(advKerb, ego) > 0 else 0.75) until abs(offsetFrom(ownLane(egoRoute), self)) < globalParameters.OPT_STOP_OFFSET or distanceLeft(advKerb, self, start) > advRoom
    do Halt()
