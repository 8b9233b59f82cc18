#: description = "The car in the target lane weaves between lanes."
#: rephrasings = [
#:   "A vehicle swings from side to side and cannot be predicted.",
#:   "The adversary slaloms along, now left, now right.",
#:   "The neighbouring car snakes to and fro across the lane markings.",
#:   "The driver wanders back and forth between two lanes.",
#:   "The lorry sways about its lane as if the driver were drunk.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["weave"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 7.5
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 0.8
#: high = 1.5
#: unit = "m"
#: meaning = "how far it swings to either side"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 3.0
#: high = 5.0
#: unit = "s"
#: meaning = "how long a full swing takes"

param OPT_ADV_SPEED = Range(4, 7.5)
param OPT_ADV_AMPLITUDE = Range(0.8, 1.5)
param OPT_ADV_PERIOD = Range(3, 5)

behavior AdvBehavior():
    do WeaveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD)
