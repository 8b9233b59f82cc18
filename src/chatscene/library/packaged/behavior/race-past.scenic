#: adversaries = ["car", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["overtake", "fast"]
#: position = "behind-beside"
#: [variants]
#: overtake-and-gone  = { adv_distance = [20, 42], adv_speed = [13, 17] }
#: emergency-overtake = { adv_distance = [10, 36], adv_speed = [13, 17], adversaries = ["emergency-vehicle"] }
#: [descriptions]
#: overtake-and-gone  = "The car overtakes the ego at high speed and keeps going in its lane."
#: emergency-overtake = "The emergency vehicle races past the ego in the next lane on its call."

param OPT_ADV_DISTANCE = Range$adv_distance  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_SPEED = Range$adv_speed  #: [m/s] how fast it overtakes

behavior AdvBehavior():
    do KeepStation(advLane, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advLane, 1, 0, globalParameters.OPT_ADV_SPEED)
