#: description = "The car comes up from behind, overtakes and then eases off to hang beside the ego's front."
#: adversaries = ["car", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["overtake", "pace"]
#: position = "behind-beside"
#: place = "road"

param OPT_ADV_SPEED = Range(12, 15)  #: [m/s] how fast it overtakes at most
param OPT_ADV_AHEAD = Range(5.6, 7.6)  #: [m] how far ahead of the ego it stays

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD, globalParameters.OPT_ADV_SPEED, 5)
