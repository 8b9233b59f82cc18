#: description = "The oncoming car drives against the traffic in the ego's lane."
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"]
#: origin = "NHTSA pre-crash typology: opposite direction; own code"
#: [slots]
#: actions = ["oncoming", "wrong-way"]
#: position = "oncoming"
#: maneuver = "straight"

param OPT_ADV_SPEED = Range(4, 9)  #: [m/s] how fast it drives
param OPT_ADV_DISTANCE = Range(35, 90)  #: [m] distance to the ego at which it comes over into the ego's lane
param OPT_ADV_OFFSET = Range(0, 3)  #: [m] how far toward its own side it keeps when it meets the ego

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 1 and gap(self, ego) < 36
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED, -globalParameters.OPT_ADV_OFFSET)
