#: description = "The car behind tailgates the ego, weaving from side to side to get past."
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: actions = ["tailgate", "weave"]
#: position = "behind"
#: place = "road"

param OPT_ADV_GAP = Range(0.6, 3)  #: [m] how much room it leaves between its bumper and the ego's
param OPT_ADV_SPEED = Range(6.8, 7.6)  #: [m/s] how fast it drives
param OPT_ADV_AMPLITUDE = Range(0.8, 1.2)  #: [m] how far it swings to either side

behavior AdvBehavior():
    do PaceOnPath(advTrajectory, ego, -(ego.length + self.length) / 2 - globalParameters.OPT_ADV_GAP, 12) for 4.5 seconds
    do WeaveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, 2.6) until headway(advTrajectory, self, ego) < (ego.length + self.length) / 2 + 0.3
    do PaceOnPath(advTrajectory, ego, -(ego.length + self.length) / 2 - globalParameters.OPT_ADV_GAP, 12)
