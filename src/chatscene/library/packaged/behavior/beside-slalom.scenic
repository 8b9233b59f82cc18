#: description = "The car slaloms across both lanes in front of the ego."
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["weave", "change-lane", "cut-in"]
#: maneuver = "straight"
#: leader = false

param OPT_ADV_AHEAD = Range(6, 12)  #: [m] how far ahead of the ego it stays
param OPT_ADV_SPEED = Range(5.5, 7)  #: [m/s] how fast it drives
param OPT_ADV_AMPLITUDE = Range(3.6, 4.2)  #: [m] how far it swings to either side
param OPT_ADV_PERIOD = Range(4.5, 6)  #: [s] how long a full swing takes

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD, 16, 5) for 2 seconds
    do WeaveOnPath(advLane, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD)
