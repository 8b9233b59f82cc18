#: description = "The oncoming car comes at high speed, weaving from side to side."
#: rephrasings = [
#:   "he's flying towards us and snaking all over the road",
#:   "Vehicle 2 approached at high speed on an erratic course.",
#:   "opposing veh, fast, swaying left-right",
#:   "The oncoming target travels at 43 km/h or more on a sinuous path about its lane.",
#:   "A motorcycle comes with big speed making zigzag.",
#:   "A biker barrels along with a violent tank-slapper.",
#:   "A speeding hatchback fishtails toward us.",
#:   "Far too quick and out of control, it sways this way and that as it comes.",
#:   "Some headcase came the other way flat out, snaking all over the place.",
#:   "Opposing vehicle approached at a high rate of speed, swaying from edge to edge.",
#:   "Bike oncoming, v. fast, zigzag.",
#:   "The opposing vehicle approaches at elevated speed with sinusoidal lateral oscillation.",
#:   "The car from the front is very fast and goes left right left right.",
#:   "Opp. traffic: high v plus slalom around its own lane, unlike the slow weaver that sits in ours.",
#:   "It tore down upon them, slithering from side to side like something hunted.",
#:   "Fast one coming at you, he can't hold a line at that speed, he's fishtailing.",
#:   "some maniac flew towards me swerving side to side at like 100",
#:   "A car hurtled toward oncoming traffic, swinging from left to right as it came.",
#:   "It approached at a breakneck rate, your Honour, and never for two seconds on the same line.",
#:   "Opposite bike coming zig-zag in full speed, like video game.",
#:   "Coming at me flat to the boards and wagging like a dog's tail.",
#:   "High-speed approach of opposing vehicle with alternating lateral deviations",
#:   "ONCOMING LUNATIC SLALOMS AT FULL SPEED",
#:   "The oncoming motorcycle slithers toward us at tremendous speed.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "weave", "fast"]
#: place = "road"
#: position = "oncoming"
#: maneuver = "straight"
#: leader = false
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 12.0
#: high = 15.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 2.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far it swings"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 3.0
#: high = 4.0
#: unit = "s"
#: meaning = "how long a full swing takes"

param OPT_ADV_SPEED = Range(12, 15)
param OPT_ADV_AMPLITUDE = Range(2, 3)
param OPT_ADV_PERIOD = Range(3, 4)

behavior AdvBehavior():
    do WeaveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD)
