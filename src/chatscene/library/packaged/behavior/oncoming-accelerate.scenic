#: description = "The oncoming car suddenly accelerates and closes the gap."
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "accelerate"]
#: position = "oncoming"

param OPT_ADV_SPEED = Range(0.5, 3)  #: [m/s] how fast it drives at first
param OPT_ADV_DISTANCE = Range(10, 45)  #: [m] distance to the ego at which it accelerates
param OPT_THROTTLE = Range(0.5, 1)  #: [1] how far the pedal is pressed

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE)
