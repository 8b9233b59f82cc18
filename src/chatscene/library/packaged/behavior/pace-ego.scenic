#: description = "The car drives parallel to the ego and blocks its path."
#: adversaries = ["car", "motorcycle"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["pace"]

param OPT_ADV_AHEAD = Range(-7, 7.5)  #: [m] how far ahead of the ego it stays

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD)
