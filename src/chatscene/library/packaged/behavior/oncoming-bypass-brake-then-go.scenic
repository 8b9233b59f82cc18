#: description = "The oncoming car brakes as if to let the ego around the obstacle, then accelerates."
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "brake", "accelerate"]
#: position = "oncoming"
#: maneuver = "bypass"

param OPT_ADV_SPEED = Range(7, 10)  #: [m/s] how fast it drives
param OPT_ADV_DISTANCE = Range(28, 60)  #: [m] distance to the ego at which it brakes
param OPT_BRAKE = Range(0.5, 0.9)  #: [1] how hard it brakes
param OPT_THROTTLE = Range(0.7, 1)  #: [1] how far the pedal is pressed

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until self.pose[3] > 4.5 and gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 1.5
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, 10)
