#: description = "The oncoming cyclist weaves from side to side across the middle of the road."
#: rephrasings = [
#:   "A bike coming at us is all over the road.",
#:   "The bicyclist approaching from the opposite direction weaved across the centerline.",
#:   "oncoming cyclist weaving over centre line",
#:   "The oncoming bicyclist target oscillates across the lane marking.",
#:   "The cyclist from front makes snakes on the road.",
#:   "A tipsy student pedals toward us in loops.",
#:   "No hands on the bars, the rider we meet drifts to and fro.",
#:   "The boy heading our way slaloms between imaginary cones.",
#:   "a cyclist coming the other way was wobbling all over the middle of the road",
#:   "The bicyclist, traveling toward V1, swerved repeatedly back and forth across the center of the roadway.",
#:   "Opp. bicycle meanders over centre line, both sides.",
#:   "The oncoming bicyclist oscillates laterally about the centre line of the road.",
#:   "One man on bicycle comes from front and goes left and right over the middle line like drunk.",
#:   "Opposite cyclist: sinusoidal path centred on the dividing line, repeatedly poking into our lane.",
#:   "He pedalled towards them in great loops, now on his own side, now on theirs, singing for all they knew.",
#:   "Pushbike coming at you, he's wandering either side of the white line, can't hold a course at all.",
#:   "bike coming at us wobbling all over the middle like he just learnt to ride",
#:   "A schoolgirl on a bicycle meandered to and fro over the centre of the road into approaching traffic",
#:   "Coming towards the car, you were now on one side of the middle and now on the other?",
#:   "Opposite cyclist going zig zag in middle of the road, coming our side, going his side, no balance",
#:   "Pushbike coming at me can't decide which half of the road he wants, so he's having both in turn",
#:   "Laterally oscillating opposing cyclist over the road centre",
#:   "Wobbly cyclist heads my way ALL OVER the center line",
#:   "The cyclist facing us meandered over the road's spine.",
#: ]
#: adversaries = ["bicycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "weave"]
#: position = "oncoming"
#: leader = false
#: place = "road"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.5
#: high = 5.5
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 1.2
#: high = 2.2
#: unit = "m"
#: meaning = "how far it swings to either side"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 3.5
#: high = 5.0
#: unit = "s"
#: meaning = "how long a full swing takes"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.0
#: high = 2.2
#: unit = "m"
#: meaning = "how far it keeps toward the ego's lane"

param OPT_ADV_SPEED = Range(3.5, 5.5)
param OPT_ADV_AMPLITUDE = Range(1.2, 2.2)
param OPT_ADV_PERIOD = Range(3.5, 5)
param OPT_SWERVE = Range(1, 2.2)

behavior AdvBehavior():
    do WeaveOnPath(advTrajectory.offset(globalParameters.OPT_SWERVE), globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD)
