#: description = "The oncoming car weaves about in the ego's lane, against the traffic."
#: adversaries = ["car", "motorcycle", "bicycle"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "wrong-way", "weave"]
#: position = "oncoming"
#: maneuver = "straight"
#: place = "road"

param OPT_ADV_SPEED = Range(4, 8)  #: [m/s] how fast it drives
param OPT_ADV_AMPLITUDE = Range(0.8, 1.3)  #: [m] how far it swings to either side
param OPT_ADV_PERIOD = Range(2.2, 3.5)  #: [s] how long a full swing takes
param OPT_ADV_OFFSET = Range(0, 3)  #: [m] how far toward its own side it keeps when it meets the ego

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < 70
    do WeaveOnPath(against(egoRoute), globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD) until abs(offsetFrom(egoRoute, self)) < 1.4 and gap(self, ego) < 26
    do WeaveOnPath(against(egoRoute).offset(-globalParameters.OPT_ADV_OFFSET), globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD)
