#: description = "The car slaloms across both lanes in front of the ego."
#: rephrasings = [
#:   "A lunatic ahead of us swings from lane to lane like a slalom skier.",
#:   "Vehicle 2 repeatedly moved back and forth between both lanes ahead of vehicle 1.",
#:   "Veh in next lane crossing in and out of ours, repeatedly.",
#:   "The target oscillates over two lane widths in front of the VUT.",
#:   "He goes our lane, his lane, our lane, his lane, without end.",
#:   "A stunt rider carves big esses over the whole carriageway.",
#:   "The van snakes over into us and out again, over and over.",
#:   "Using both lanes as his playground, the driver sweeps across us and back.",
#:   "boy racer in front of me was treating both lanes like a ski run, left right left right",
#:   "Suspect motorcycle repeatedly changed lanes without signal, zigzagging over both lanes ahead of complainant's car.",
#:   "Car lane-hops to & fro in front of us, L-R-L-R, uses both lanes.",
#:   "The target performs successive alternating lane changes ahead of the VUT, covering two lanes.",
#:   "One car goes to my lane, to the other lane, again to my lane, like snake, in front of me.",
#:   "Actor does a full-width S-curve over two lanes in front of the AV; it keeps entering and leaving our lane.",
#:   "The police car had swung over before her, then away, then over once more, sewing the two lanes together like a needle.",
#:   "Traffic unit to control: biker's swooping from one lane to the other and back, right under the nose of the car behind him, can't pick one.",
#:   "bro thinks its mario kart, hes swapping lanes nonstop in front of us",
#:   "A motorcyclist was seen criss-crossing both lanes ahead of commuters in what one called a circus act",
#:   "He crossed into my client's lane and out again, and in again, how many times, Mr Dent? At least four, sir.",
#:   "That fellow changing lane like nobody's business, this lane that lane this lane, right in front of us",
#:   "Can't settle on a lane, this one, he's had mine, then his, then mine again, like he's lacing a shoe",
#:   "Repeated two-lane oscillation of a vehicle ahead; recurrent re-entry into own lane",
#:   "Cop car zigzagging across BOTH lanes in front of me?!",
#:   "The hot hatch braided the two lanes together ahead of us.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["advLane"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["weave", "cut-in", "change-lane"]
#: leader = false
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 6.0
#: high = 12.0
#: unit = "m"
#: meaning = "how far ahead of the ego it stays"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.5
#: high = 6.5
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 3.2
#: high = 3.8
#: unit = "m"
#: meaning = "how far it swings to either side"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 4.5
#: high = 6.0
#: unit = "s"
#: meaning = "how long a full swing takes"

param OPT_ADV_AHEAD = Range(6, 12)
param OPT_ADV_SPEED = Range(4.5, 6.5)
param OPT_ADV_AMPLITUDE = Range(3.2, 3.8)
param OPT_ADV_PERIOD = Range(4.5, 6)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD, 16, 5) for 2 seconds
    do WeaveOnPath(advLane, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD)
