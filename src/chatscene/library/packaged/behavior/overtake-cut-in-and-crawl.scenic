#: description = "The car overtakes the ego, moves in front of it and then crawls along."
#: adversaries = ["car", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["overtake", "cut-in", "slow"]
#: position = "behind-beside"
#: maneuver = "straight"
#: leader = false

param OPT_ADV_SPEED = Range(11.5, 15)  #: [m/s] how fast it overtakes at most
param OPT_ADV_AHEAD = Range(9, 15)  #: [m] how far ahead of the ego it is when it moves over
param OPT_ADV_CRAWL = Range(1.2, 2.8)  #: [m/s] how fast it crawls

behavior AdvBehavior():
    do DrivePath(advLane, globalParameters.OPT_ADV_SPEED) until headway(egoRoute, ego, self) > globalParameters.OPT_ADV_AHEAD
    do DrivePath(egoRoute, globalParameters.OPT_ADV_CRAWL)
