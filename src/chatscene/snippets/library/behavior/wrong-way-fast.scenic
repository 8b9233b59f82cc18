#: description = "The oncoming car races against the traffic in the ego's lane."
#: rephrasings = [
#:   "some idiot is hurtling at us the wrong way down our lane",
#:   "Vehicle 2 approached head-on in the wrong lane at high speed.",
#:   "wrong-way, very fast, our lane",
#:   "The target travels at 45 km/h or more in the lane of the VUT against its direction.",
#:   "A motorcycle comes with very high speed in contrary sense in our lane.",
#:   "A getaway car tears toward us on the wrong side of the road.",
#:   "The police car on a chase storms up our lane in the opposite direction.",
#:   "Flat out, a biker bears down on the ego, head on.",
#:   "There was someone hammering along on my side of the road straight at me, like a missile.",
#:   "Wrong-way vehicle was traveling at a high rate of speed in Unit 1's lane.",
#:   "Ghost driver, our lane, v. high speed.",
#:   "The target vehicle travels counter to the permitted direction in the lane of the test vehicle at constant high speed.",
#:   "One comes very fast on my lane from the wrong direction.",
#:   "Wrong-way actor in our lane from the start, constant high v, no overtake, no return.",
#:   "It was on their side when they first saw it, and it bore down on them like an express train.",
#:   "All units, wrong-way motorcycle, he's flying, head-on in your lane, get onto the shoulder.",
#:   "wrong way driver FLYING at me in my lane im shaking",
#:   "A car driving the wrong way at great speed bore down on motorists in their own lane.",
#:   "He drove contrary to the flow, in my client's lane, with a velocity that beggars belief.",
#:   "Against traffic this car come damn fast, my lane some more.",
#:   "Wrong side of the road, my side, and going like the clappers with it.",
#:   "High-speed counterflow travel of opposing vehicle in own lane",
#:   "WRONG-WAY RACER HEADS STRAIGHT FOR ME",
#:   "The wrong-way motorcycle thunders down our lane.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "wrong-way", "fast"]
#: position = "oncoming"
#: maneuver = "straight"
#: leader = false
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 12.5
#: high = 17.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 65.0
#: high = 95.0
#: unit = "m"
#: meaning = "distance to the ego at which it comes over into the ego's lane"
#: [[parameters]]
#: name = "OPT_ADV_OFFSET"
#: low = 0.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far toward its own side it keeps when it meets the ego"

param OPT_ADV_SPEED = Range(12.5, 17)
param OPT_ADV_DISTANCE = Range(65, 95)
param OPT_ADV_OFFSET = Range(0, 3)

behavior AdvBehavior():
    do ThrottleOnPath(advTrajectory, 1, 0, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(against(egoRoute), 1, 0, globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 1 and gap(self, ego) < 50
    do ThrottleOnPath(against(egoRoute), 1, -globalParameters.OPT_ADV_OFFSET, globalParameters.OPT_ADV_SPEED)
