#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "base scenario right-turn; own code"
#: [variants]
#: accelerate-then-brake = { actions = ["accelerate", "brake"], adv_distance = [-15, 20], throttle = [0.7, 1], throttle_time = [1, 2.5], brake = [0.4, 1] }
#: lead-sprint-and-stop  = { actions = ["accelerate", "brake", "stop", "block"], adv_distance = [0, 25], throttle = [0.6, 1], throttle_time = [0.8, 2], brake = [0.6, 1], position = "ahead", adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"], origin = "own code" }
#: [descriptions]
#: accelerate-then-brake = "The car suddenly accelerates and then decelerates."
#: lead-sprint-and-stop  = "The car ahead accelerates away and shortly after brakes to a dead stop."

param OPT_ADV_DISTANCE = Range$adv_distance  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_THROTTLE = Range$throttle  #: [1] how far the pedal is pressed
param OPT_THROTTLE_TIME = Range$throttle_time  #: [s] for how long it presses the pedal
param OPT_BRAKE = Range$brake  #: [1] how hard it brakes

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE) for globalParameters.OPT_THROTTLE_TIME seconds
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
