#: description = "The emergency vehicle threads its way past the ego, swinging from side to side."
#: rephrasings = [
#:   "The ambulance zigzags through and past us.",
#:   "The emergency vehicle maneuvered left and right while passing vehicle 1.",
#:   "EMS snakes by, overtaking.",
#:   "The emergency vehicle overtakes the VUT with lateral oscillations.",
#:   "The police goes left and right between the cars and passes.",
#:   "A fire engine sways by with its siren on, nudging at our side.",
#:   "Paramedics slalom past everybody, us included.",
#:   "A patrol car in pursuit whips to and fro and gets ahead.",
#:   "A fire engine came slaloming through the traffic with its siren on and wriggled past me.",
#:   "The responding squad car negotiated traffic in a zigzag fashion as it went around Unit 1.",
#:   "Amb. on blue lights snaking L-R-L, gets by ego.",
#:   "The emergency vehicle target passes the VUT while executing repeated alternating lateral displacements.",
#:   "The ambulance with siren goes zig-zag and passes me, left and right and left.",
#:   "EV doesn't hold a lane while passing: sways left-right-left through gaps around us, lights on.",
#:   "It came up with its lights whirling, jinked one way, jinked the other, and somehow squirmed by her.",
#:   "Medic unit is picking its way round you, ducking left and right, so keep dead straight and predictable.",
#:   "cop car was zigzagging round everyone and squeezed by me, actual GTA",
#:   "An ambulance picked a crooked path around queueing motorists, tacking left and right to get ahead.",
#:   "The ambulance did not pass in a straight line, did it; it went first to one side and then the other until it was by?",
#:   "Fire engine was going left right left right in between and somehow got past me.",
#:   "Ambulance is dancing round the lot of us like a needle through cloth, finally squirms by me.",
#:   "Serpentine passing of ego by emergency vehicle on active response.",
#:   "AMBULANCE SLALOMS PAST ME IN TRAFFIC",
#:   "The siren-blaring patrol car snaked around us.",
#: ]
#: adversaries = ["emergency-vehicle"]
#: requires = ["advLane"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["overtake", "weave"]
#: position = "behind-beside"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 12.0
#: high = 15.0
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
#: low = 2.6
#: high = 3.6
#: unit = "s"
#: meaning = "how long a full swing takes"

param OPT_ADV_SPEED = Range(12, 15)
param OPT_ADV_AMPLITUDE = Range(0.8, 1.5)
param OPT_ADV_PERIOD = Range(2.6, 3.6)

behavior AdvBehavior():
    do WeaveOnPath(advLane, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD)
