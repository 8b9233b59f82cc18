#: description = "The oncoming car drifts over the centre line and comes back."
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "NHTSA pre-crash typology: opposite direction, no manoeuvre; own code"
#: [slots]
#: actions = ["oncoming", "turn-back"]
#: position = "oncoming"
#: maneuver = "straight"

param OPT_ADV_SPEED = Range(5, 9)  #: [m/s] how fast it drives
param OPT_ADV_DISTANCE = Range(50, 80)  #: [m] distance to the ego at which it starts to drift
param OPT_ADV_AMPLITUDE = Range(1.5, 3)  #: [m] how far it drifts
param OPT_ADV_PERIOD = Range(4.5, 6.5)  #: [s] twice as long as it is off its line

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do WeaveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD) for 0.5 * globalParameters.OPT_ADV_PERIOD seconds
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
