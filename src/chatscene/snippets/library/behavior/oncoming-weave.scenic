#: description = "The oncoming car weaves from side to side as it approaches."
#: rephrasings = [
#:   "A vehicle from ahead swings about its lane toward the ego.",
#:   "The opposing driver slaloms over the centre line and back.",
#:   "The adversary comes on in a wavering course.",
#:   "The approaching motorbike snakes to and fro.",
#:   "Opposing traffic sways erratically and keeps coming.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "weave"]
#: position = "oncoming"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 8.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 0.8
#: high = 1.4
#: unit = "m"
#: meaning = "how far it swings to either side"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 2.5
#: high = 4.5
#: unit = "s"
#: meaning = "how long a full swing takes"

param OPT_ADV_SPEED = Range(4, 8)
param OPT_ADV_AMPLITUDE = Range(0.8, 1.4)
param OPT_ADV_PERIOD = Range(2.5, 4.5)

behavior AdvBehavior():
    do WeaveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD)
