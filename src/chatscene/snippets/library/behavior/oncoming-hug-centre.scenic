#: description = "The slow oncoming truck hugs the centre of the road."
#: rephrasings = [
#:   "this big slow thing is coming at us right down the middle",
#:   "Vehicle 2, an oncoming truck, straddled the centreline at low speed.",
#:   "opposing truck, slow, half over the line",
#:   "The oncoming heavy vehicle travels at less than 14 km/h with a constant offset toward the lane of the VUT.",
#:   "A bus comes slowly and it takes a part of our lane because is too wide.",
#:   "A wide load lumbers along, sticking out into the ego's half.",
#:   "The lorry opposite crawls over the white line and leaves hardly any room.",
#:   "A coach from ahead plods along far too near the middle.",
#:   "There was a great big lorry trundling towards me with its wheels right on the white line.",
#:   "Opposing commercial vehicle was traveling slowly, riding the center line.",
#:   "Bus oncoming, slow, close to middle line, little room.",
#:   "The opposing heavy vehicle proceeds at low speed with a lateral offset towards the road centreline.",
#:   "A truck comes slow from the front and drives too much in the middle.",
#:   "Opp. HGV with lane offset at the divider, low v, squeezes our lateral clearance.",
#:   "It lumbered towards them down the very middle and left them hardly room to breathe.",
#:   "That wagon coming at you is taking his half out of the middle, and he's in no hurry, so keep well in.",
#:   "big slow truck coming at me basically sitting on the middle line",
#:   "A lumbering lorry came the other way with its flank against the dividing line, leaving little room to pass.",
#:   "The opposing coach, travelling gently enough, kept as near the centre of the highway as it could without going over.",
#:   "Opposite bus moving slow but sticking to the middle line, my side also became tight.",
#:   "Great lump of a lorry chugging towards me, half an inch off the middle, move over can't you.",
#:   "Reduced lateral clearance owing to slow opposing heavy vehicle close to road centre",
#:   "TRUCK HOGS THE MIDDLE - squeaky bum moment",
#:   "The oncoming bus lumbers by with its side against the median line.",
#: ]
#: adversaries = ["truck", "bus"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "slow", "follow"]
#: position = "oncoming"
#: maneuver = "straight"
#: leader = false
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.2
#: high = 3.8
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 0.7
#: high = 1.6
#: unit = "m"
#: meaning = "how far towards the ego's side it keeps"

param OPT_ADV_SPEED = Range(2.2, 3.8)
param OPT_SWERVE = Range(0.7, 1.6)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE)
