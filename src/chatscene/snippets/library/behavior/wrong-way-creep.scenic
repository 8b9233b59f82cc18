#: description = "The oncoming car crawls against the traffic in the ego's lane."
#: rephrasings = [
#:   "an old chap is pottering toward us on the wrong side of the road",
#:   "Vehicle 2 was proceeding slowly in the wrong direction in lane 1.",
#:   "wrong-way, walking pace, our lane",
#:   "The target moves at less than 13 km/h in the lane of the VUT against its direction.",
#:   "A bus goes slowly in the contrary direction in the lane of the ego.",
#:   "A sightseeing coach rolls leisurely the wrong way up our lane.",
#:   "A confused motorist trundles toward the ego on the ego's own side.",
#:   "The lorry inches toward us, facing the wrong way in our lane.",
#:   "some pensioner was inching along towards me on my side of the road, going against everybody",
#:   "V2 was traveling against the flow of traffic in V1's lane at a very low speed.",
#:   "Truck in our lane, wrong dir., creeping twd us.",
#:   "The oncoming target proceeds at very low speed in the VUT's lane against the permitted direction.",
#:   "The bus comes in my lane in false direction, very slow.",
#:   "Ghost driver, crawl version: head-on in the ego lane at ~1-2 m/s, keeps coming and never stops.",
#:   "It came on against the stream, in their own lane, no faster than a man might walk, and it would not give way.",
#:   "Reports of a car on the wrong side, heading into traffic, he's only doing walking pace but he's still coming.",
#:   "theres a car coming the wrong way in our lane but like super slow",
#:   "A lost coach inched up the lane in the face of traffic",
#:   "You were in the wrong lane, facing my client, and advancing at a mere crawl?",
#:   "Lorry coming wrong side in our lane, slowly slowly, as if correct only",
#:   "Wrong way up my lane, and he's in no hurry about it either, tiptoeing along like it'll make it all right",
#:   "Low-speed opposing traffic in own lane, continuous wrong-way travel",
#:   "Bus drives the WRONG WAY in my lane at 5 km/h",
#:   "The pickup sneaked along against the flow toward us.",
#: ]
#: adversaries = ["car", "truck", "bus"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "wrong-way", "slow"]
#: position = "oncoming"
#: maneuver = "straight"
#: leader = false
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.5
#: high = 3.5
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_OFFSET"
#: low = 0.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far toward its own side it keeps when it meets the ego"

param OPT_ADV_SPEED = Range(1.5, 3.5)
param OPT_ADV_OFFSET = Range(0, 3)

behavior AdvBehavior():
    do DrivePath(advTrajectory, 8) until gap(self, ego) < 75
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 1 and gap(self, ego) < 30
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED, -globalParameters.OPT_ADV_OFFSET)
