#: description = "The car slaloms across both lanes in front of the ego."
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["weave", "cut-in", "change-lane"]
#: maneuver = "straight"
#: leader = false

param OPT_ADV_AHEAD = Range(6, 12)  #: [m] how far ahead of the ego it stays
param OPT_ADV_SPEED = Range(4.5, 6.5)  #: [m/s] how fast it drives
param OPT_ADV_AMPLITUDE = Range(3.2, 3.8)  #: [m] how far it swings to either side
param OPT_ADV_PERIOD = Range(4.5, 6)  #: [s] how long a full swing takes

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD, 16, 5) for 2 seconds
    do WeaveOnPath(advLane, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD)
