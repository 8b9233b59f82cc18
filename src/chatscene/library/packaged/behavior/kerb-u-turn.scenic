#: description = "The parked car pulls out and makes a U-turn across the road."
#: adversaries = ["car", "truck", "motorcycle", "emergency-vehicle"]
#: origin = "NHTSA pre-crash typology: making a U-turn; own code"
#: [slots]
#: actions = ["pull-out", "u-turn"]
#: side = "right"
#: position = "kerb"
#: maneuver = "straight"

param OPT_ADV_DISTANCE = Range(14, 30)  #: [m] how far the ego still has to go to it when it moves off
param OPT_ADV_SPEED = Range(2.5, 4)  #: [m/s] how fast it turns round
param OPT_TURN_RADIUS = Range(6, 7)  #: [m] the radius of its turn

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 4) for 0.4 seconds
    do TurnOff(3.1, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_TURN_RADIUS)
    do MoveAhead(6)
