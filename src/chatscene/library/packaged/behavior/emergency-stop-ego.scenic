#: description = "The emergency vehicle overtakes the ego, cuts in and stops in front of it."
#: adversaries = ["emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["overtake", "cut-in", "brake", "stop", "block"]
#: position = "behind-beside"
#: maneuver = "straight"
#: leader = false

param OPT_ADV_AHEAD = Range(9, 16)  #: [m] how far ahead of the ego it is when it moves over
param OPT_BRAKE = Range(0.6, 1)  #: [1] how hard it brakes

behavior AdvBehavior():
    do DrivePath(advLane, 14) until headway(egoRoute, ego, self) > globalParameters.OPT_ADV_AHEAD
    do DrivePath(egoRoute, 9) until abs(offsetFrom(egoRoute, self)) < 1
    do BrakeOnPath(egoRoute, globalParameters.OPT_BRAKE)
