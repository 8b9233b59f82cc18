#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: position = "ahead"
#: [variants]
#: lead-brake-to-crawl = { actions = ["brake", "slow"], adv_distance = [-15, 20], adv_ahead = [14, 24], brake = [0.45, 1], adv_speed = [1, 3] }
#: lead-coast-down     = { actions = ["slow", "follow"], adv_distance = [-5, 30], adv_ahead = [14, 26], brake = [0.08, 0.17], adv_speed = [1.2, 3.4], adversaries = ["car", "truck", "motorcycle", "emergency-vehicle"] }
#: [descriptions]
#: lead-brake-to-crawl = "The car ahead brakes hard and then creeps on at walking pace."
#: lead-coast-down     = "The car ahead takes its foot off the gas and coasts down to a crawl without stopping."

param OPT_ADV_DISTANCE = Range$adv_distance  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_ADV_AHEAD = Range$adv_ahead  #: [m] how far ahead of the ego it drives before it acts
param OPT_BRAKE = Range$brake  #: [1] how hard it brakes, or how strongly the engine drags, as a share of full braking
param OPT_ADV_SPEED = Range$adv_speed  #: [m/s] how fast it rolls on

behavior AdvBehavior():
    do PaceOnPath(advTrajectory, ego, globalParameters.OPT_ADV_AHEAD, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
