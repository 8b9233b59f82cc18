#: description = "The oncoming car weaves from side to side and then stops."
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "weave", "stop"]
#: position = "oncoming"
#: maneuver = "straight"
#: place = "road"

param OPT_ADV_SPEED = Range(5, 8)  #: [m/s] how fast it drives
param OPT_ADV_AMPLITUDE = Range(1.3, 2.2)  #: [m] how far it swings
param OPT_ADV_PERIOD = Range(2.5, 3.5)  #: [s] how long a full swing takes
param OPT_STOP_TIME = Range(4, 6)  #: [s] how long it weaves before it stops

behavior AdvBehavior():
    do WeaveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD) for globalParameters.OPT_STOP_TIME seconds
    do BrakeOnPath(advTrajectory, 0.7, 1.5)
