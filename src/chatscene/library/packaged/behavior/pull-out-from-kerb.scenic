#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "NHTSA pre-crash typology: leaving a parked position; own code"
#: [slots]
#: position = "kerb"
#: [variants]
#: kerb-pull-out        = { actions = ["pull-out"], adv_distance = [12, 30], adv_speed = [4, 7.5], pace = 3, pause = 0.3 }
#: kerb-pull-out-slowly = { actions = ["pull-out", "slow"], adv_distance = [18, 40], adv_speed = [1.6, 3], pace = 3, pause = 0.3, side = "right", origin = "own code" }
#: [descriptions]
#: kerb-pull-out        = "The parked car pulls out from the kerb into the ego's lane and drives on."
#: kerb-pull-out-slowly = "The parked car creeps out from the kerb and trundles along in front of the ego."

param OPT_ADV_DISTANCE = Range$adv_distance  #: [m] how far the ego still has to go to it when it moves off
param OPT_ADV_SPEED = Range$adv_speed  #: [m/s] how fast it drives

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, $pace) for $pause seconds
    do DrivePath(ownLane(egoRoute), globalParameters.OPT_ADV_SPEED)
