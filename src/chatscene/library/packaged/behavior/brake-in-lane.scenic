#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "base scenario lane-changing; own code"
#: [variants]
#: lane-brake       = { actions = ["brake"], adv_distance = [-15, 20], brake = [0.4, 1], adversaries = ["car", "truck", "bus", "motorcycle"] }
#: lead-gentle-stop = { actions = ["slow", "stop"], adv_distance = [5, 30], brake = [0.17, 0.24], position = "ahead", origin = "NHTSA pre-crash typology: lead vehicle decelerating; own code" }
#: lead-hard-stop   = { actions = ["brake", "stop", "block"], adv_distance = [5, 30], brake = [0.7, 1], position = "ahead", origin = "Euro NCAP CCRb, UN R152; own code" }
#: [descriptions]
#: lane-brake       = "The car in the target lane suddenly brakes."
#: lead-gentle-stop = "The car ahead slows down gradually, comes to a stop and stands in the lane."
#: lead-hard-stop   = "The car ahead slams on the brakes, comes to a dead stop and stays there."

param OPT_ADV_DISTANCE = Range$adv_distance  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_BRAKE = Range$brake  #: [1] how hard it brakes

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
