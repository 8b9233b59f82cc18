#: description = "The car overtakes the ego and cuts in close in front of it."
#: adversaries = ["car", "motorcycle"]
#: origin = "NHTSA pre-crash typology: passing; own code"
#: [slots]
#: actions = ["overtake", "cut-in"]
#: position = "behind-beside"
#: maneuver = "straight"
#: leader = false

param OPT_ADV_SPEED = Range(11, 14)  #: [m/s] how fast it overtakes at most
param OPT_ADV_AHEAD = Range(0.5, 6)  #: [m] how far ahead of the ego it is when it moves over

behavior AdvBehavior():
    do DrivePath(advLane, globalParameters.OPT_ADV_SPEED) until headway(egoRoute, ego, self) > globalParameters.OPT_ADV_AHEAD
    do DrivePath(egoRoute, 8)
