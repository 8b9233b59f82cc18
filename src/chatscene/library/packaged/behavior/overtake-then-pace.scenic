#: description = "The car comes up from behind, overtakes and then eases off to hang beside the ego's front."
#: adversaries = ["car", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["overtake", "pace"]
#: position = "behind-beside"
#: place = "road"

param OPT_ADV_SPEED = Range(12, 15)  #: [m/s] how fast it overtakes at most
param OPT_ADV_AHEAD = Range(2, 6)  #: [m] how far ahead of the ego it stays

behavior AdvBehavior():
    do DrivePath(advLane, globalParameters.OPT_ADV_SPEED) until headway(egoRoute, ego, self) > 9.5
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD, globalParameters.OPT_ADV_SPEED, 2.5)
