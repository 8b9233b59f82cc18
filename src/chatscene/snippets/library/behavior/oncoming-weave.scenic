#: description = "The oncoming car weaves from side to side as it approaches."
#: rephrasings = [
#:   "A vehicle from ahead swings about its lane toward the ego.",
#:   "The opposing driver slaloms over the centre line and back.",
#:   "The adversary comes on in a wavering course.",
#:   "The approaching motorbike snakes to and fro.",
#:   "Opposing traffic sways erratically and keeps coming.",
#:   "the one coming toward us is swaying all over the road",
#:   "Vehicle 2 approached from the opposite direction on a weaving course.",
#:   "opposing veh, zigzag about its lane",
#:   "There was someone coming the other way snaking all over the place.",
#:   "The approaching vehicle was weaving left and right as it neared Unit 1.",
#:   "Opp. veh zigzag, L-R-L, closing.",
#:   "The oncoming target approaches with repeated alternating lateral deviations.",
#:   "The motorbike comes against me and makes zig-zag all the time.",
#:   "Opposite-direction actor with oscillating path; continuous, doesn't settle; lateral prediction jitters.",
#:   "He came tacking down the road to meet her, first one side, then the other, like a dinghy in a squall.",
#:   "See the headlights coming swinging about? He can't hold a line, keep well over to the edge.",
#:   "the car coming at us was going all squiggly",
#:   "An approaching van wound along the road from edge to edge, alarming drivers.",
#:   "The vehicle bearing toward you swung to one side, then the other, and so on until it reached you?",
#:   "Opposite bus was coming left-right, left-right, I don't know where to go.",
#:   "One's coming at me like he's dodging bullets, this side, that side, take your pick.",
#:   "Oscillating lateral path of approaching opposing vehicle.",
#:   "ONCOMING CAR ALL OVER THE ROAD",
#:   "The oncoming motorcycle slithered from side to side.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "weave"]
#: position = "oncoming"
#: place = "road"
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
