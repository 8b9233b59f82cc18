#: description = "The car behind swings out, overtakes the ego, moves back in front of it and brakes."
#: adversaries = ["car", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["overtake", "change-lane", "brake"]
#: position = "behind"
#: maneuver = "straight"
#: place = "road"

param OPT_ADV_SPEED = Range(11.5, 15)  #: [m/s] how fast it overtakes at most
param OPT_ADV_AHEAD = Range(1, 5)  #: [m] how far ahead of the ego it is when it moves over
param OPT_BRAKE = Range(0.6, 1)  #: [1] how hard it brakes

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) for 0.8 seconds
    do DrivePath(extended(adjacentLane, 20), globalParameters.OPT_ADV_SPEED) until headway(egoRoute, ego, self) > globalParameters.OPT_ADV_AHEAD
    do DrivePath(egoRoute, 8) until abs(offsetFrom(egoRoute, self)) < 1
    do BrakeOnPath(egoRoute, globalParameters.OPT_BRAKE) until self.pose[3] < 1
    do DrivePath(egoRoute, 4)
