#: description = "The car overtakes the ego and then brakes hard in its own lane."
#: adversaries = ["car", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["overtake", "brake"]
#: position = "behind-beside"
#: place = "road"

param OPT_ADV_SPEED = Range(11.5, 15)  #: [m/s] how fast it overtakes at most
param OPT_ADV_AHEAD = Range(6, 14)  #: [m] how far ahead of the ego it is when it brakes
param OPT_BRAKE = Range(0.5, 1)  #: [1] how hard it brakes

behavior AdvBehavior():
    do DrivePath(advLane, globalParameters.OPT_ADV_SPEED) until headway(egoRoute, ego, self) > globalParameters.OPT_ADV_AHEAD
    do BrakeOnPath(advLane, globalParameters.OPT_BRAKE)
