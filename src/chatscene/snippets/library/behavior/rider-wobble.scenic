#: description = "The rider ahead rides slowly and wobbles from side to side."
#: rephrasings = [
#:   "The old boy on the bike in front is wobbling all over the shop at walking pace.",
#:   "The bicyclist traveled slowly ahead of Vehicle 1 on an unsteady path.",
#:   "slow bike ahead, wobbling",
#:   "The bicyclist target moves at low speed ahead of the VUT with lateral oscillations.",
#:   "The cyclist before us is slow and goes left and right.",
#:   "A child learning to ride teeters along in our lane.",
#:   "A rider with shopping on the handlebars cannot keep a straight line.",
#:   "The scooter in front dawdles in wavy lines as if looking for an address.",
#:   "The cyclist in front was tottering along all over the place, hardly moving.",
#:   "The bicyclist ahead was riding unsteadily at low speed, drifting left and right.",
#:   "Bike ahead slow + unsteady, L-R-L. Keeps going.",
#:   "The leading cyclist target proceeds at low speed with continuous lateral oscillation.",
#:   "The bicycle in front is slow and shakes left and right.",
#:   "Slow leader VRU with lateral wander; no stop or turn, just unstable.",
#:   "She was new to the thing, and went along before him at a crawl, her front wheel hunting this way and that.",
#:   "Give him a wide berth, he's a shaky rider, slow as you like and swaying about in front of you.",
#:   "this old guy on a bike in front is so slow and so wobbly im scared for him",
#:   "An elderly cyclist teetered along at a modest pace, holding no line, witnesses said.",
#:   "The rider ahead was slow, and he could not keep a straight course; he swayed, did he not?",
#:   "Front cycle uncle going very slow and shaking this side that side, cannot pass.",
#:   "Pedalling through treacle in front of me and swaying like a washing line.",
#:   "Slow leading two-wheeler with pronounced lateral instability.",
#:   "WOBBLIEST CYCLIST IN TOWN",
#:   "The rider ahead joggled slowly left and right.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["slow", "weave"]
#: position = "ahead"
#: leader = false
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.4
#: high = 3.2
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 1.3
#: high = 1.7
#: unit = "m"
#: meaning = "how far it wobbles to either side"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 3.6
#: high = 4.6
#: unit = "s"
#: meaning = "how long a full swing takes"

param OPT_ADV_SPEED = Range(2.4, 3.2)
param OPT_ADV_AMPLITUDE = Range(1.3, 1.7)
param OPT_ADV_PERIOD = Range(3.6, 4.6)

behavior AdvBehavior():
    do WeaveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD)
