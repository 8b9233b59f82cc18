#: description = "The car overtakes the ego, cuts in and brakes right in front of it."
#: adversaries = ["car", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["overtake", "cut-in", "brake"]
#: position = "behind-beside"
#: maneuver = "straight"
#: leader = false

param OPT_ADV_SPEED = Range(11.5, 15)  #: [m/s] how fast it overtakes at most
param OPT_ADV_AHEAD = Range(1, 6)  #: [m] how far ahead of the ego it is when it moves over
param OPT_BRAKE = Range(0.6, 1)  #: [1] how hard it brakes

behavior AdvBehavior():
    do DrivePath(advLane, globalParameters.OPT_ADV_SPEED) until headway(egoRoute, ego, self) > globalParameters.OPT_ADV_AHEAD
    do DrivePath(egoRoute, 8) until abs(offsetFrom(egoRoute, self)) < 1
    do BrakeOnPath(egoRoute, globalParameters.OPT_BRAKE) until self.pose[3] < 2
    do DrivePath(egoRoute, 7)
