#: description = "The oncoming car brakes hard and stops in its lane."
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "brake", "stop"]
#: position = "oncoming"

param OPT_ADV_SPEED = Range(5, 10)  #: [m/s] how fast it drives
param OPT_ADV_DISTANCE = Range(15, 45)  #: [m] distance to the ego at which it brakes
param OPT_BRAKE = Range(0.4, 1)  #: [1] how hard it brakes

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until self.pose[3] > 4 and gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
