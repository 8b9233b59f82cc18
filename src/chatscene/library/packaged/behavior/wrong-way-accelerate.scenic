#: description = "The oncoming car pulls out into the ego's lane and accelerates to overtake."
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "wrong-way", "accelerate"]
#: position = "oncoming"
#: maneuver = "straight"

param OPT_ADV_SPEED = Range(2, 4.5)  #: [m/s] how fast it drives
param OPT_THROTTLE = Range(0.5, 1)  #: [1] how far the pedal is pressed
param OPT_ADV_DISTANCE = Range(35, 90)  #: [m] distance to the ego at which it pulls out and accelerates
param OPT_ADV_OFFSET = Range(0, 3)  #: [m] how far toward its own side it keeps when it meets the ego

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(against(egoRoute), globalParameters.OPT_THROTTLE, 0, 14) until abs(offsetFrom(egoRoute, self)) < 1 and gap(self, ego) < 40
    do ThrottleOnPath(against(egoRoute), globalParameters.OPT_THROTTLE, -globalParameters.OPT_ADV_OFFSET, 14)
