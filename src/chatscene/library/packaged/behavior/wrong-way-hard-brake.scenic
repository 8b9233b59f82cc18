#: description = "The oncoming car comes the wrong way in the ego's lane, brakes hard, and stops."
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "wrong-way", "brake", "stop"]
#: position = "oncoming"
#: maneuver = "straight"

param OPT_ADV_SPEED = Range(7, 12)  #: [m/s] how fast it drives
param OPT_BRAKE = Range(0.5, 1)  #: [1] how hard it brakes
param OPT_ADV_DISTANCE = Range(15, 45)  #: [m] distance to the ego at which it brakes

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < 75
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED) until self.pose[3] > 5 and abs(offsetFrom(egoRoute, self)) < 1 and gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(against(egoRoute), globalParameters.OPT_BRAKE)
