#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "own code"
#: [variants]
#: oncoming-weave       = { actions = ["oncoming", "weave"], position = "oncoming", place = "road", adv_speed = [4, 8], adv_amplitude = [0.8, 1.4], adv_period = [2.5, 4.5], way = "advTrajectory", origin = "base scenario vehicle-passing; own code" }
#: oncoming-weave-fast  = { actions = ["oncoming", "weave", "fast"], position = "oncoming", place = "road", adv_speed = [12, 15], adv_amplitude = [2, 3], adv_period = [3, 4], way = "advTrajectory", maneuver = "straight", adversaries = ["car", "motorcycle"] }
#: rider-wobble         = { actions = ["slow", "weave"], position = "ahead", adv_speed = [2.4, 3.2], adv_amplitude = [2.1, 2.6], adv_period = [3.6, 4.6], way = "advTrajectory", maneuver = "straight", leader = false, adversaries = ["bicycle", "motorcycle"] }
#: emergency-weave-past = { actions = ["overtake", "weave"], position = "behind-beside", adv_speed = [12, 15], adv_amplitude = [0.8, 1.5], adv_period = [2.6, 3.6], way = "advLane", adversaries = ["emergency-vehicle"] }
#: weave-between-lanes  = { actions = ["weave"], adv_speed = [4, 7.5], adv_amplitude = [0.75, 1.05], adv_period = [3, 5], way = "advLane", origin = "base scenario lane-changing; own code" }
#: rider-oncoming-weave = { actions = ["oncoming", "weave"], position = "oncoming", place = "road", adv_speed = [3.5, 5.5], adv_amplitude = [1.2, 2.2], adv_period = [3.5, 5], way = "advTrajectory.offset(globalParameters.OPT_SWERVE)", swerve = [1, 2.2], adversaries = ["bicycle"] }
#: [descriptions]
#: oncoming-weave       = "The oncoming car weaves from side to side as it approaches."
#: oncoming-weave-fast  = "The oncoming car comes at high speed, weaving from side to side."
#: rider-wobble         = "The rider ahead rides slowly and wobbles from side to side."
#: emergency-weave-past = "The emergency vehicle threads its way past the ego, swinging from side to side."
#: weave-between-lanes  = "The car in the target lane weaves between lanes."
#: rider-oncoming-weave = "The oncoming cyclist weaves from side to side across the middle of the road."

param OPT_ADV_SPEED = Range$adv_speed  #: [m/s] how fast it goes
param OPT_ADV_AMPLITUDE = Range$adv_amplitude  #: [m] how far it swings to either side
param OPT_ADV_PERIOD = Range$adv_period  #: [s] how long a full swing takes
param OPT_SWERVE = Range$swerve  #: if swerve  #: [m] how far it keeps toward the ego's lane

behavior AdvBehavior():
    do WeaveOnPath($way, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD)
