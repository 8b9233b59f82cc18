#: description = "The rider ahead starts to wobble, loses balance and falls in the lane."
#: adversaries = ["bicycle", "motorcycle"]
#: origin = "own code"
#: [slots]
#: actions = ["weave", "stop"]
#: position = "ahead"
#: maneuver = "straight"

param OPT_ADV_SPEED = Range(4, 6)  #: [m/s] how fast it rides
param OPT_ADV_AMPLITUDE = Range(1, 1.6)  #: [m] how far it wobbles to either side
param OPT_ADV_PERIOD = Range(3, 3.6)  #: [s] how long a full swing takes
param OPT_ADV_TIME = Range(6, 8)  #: [s] how long it wobbles before it falls

behavior AdvBehavior():
    do WeaveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD) for globalParameters.OPT_ADV_TIME seconds
    do Halt()
