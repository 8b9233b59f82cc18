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
#:   "Crawling head-on in our lane: a lorry, wrong direction.",
#:   "lost bus dribbles along our lane agianst the flow towards us",
#:   "Slow ghost driver: car toward us, our lane, walking speed.",
#:   "WRONG-WAY GRANDAD at 8 km/h, in my lane, still coming",
#:   "Have a van creep toward the AV in the AV's own lane.",
#:   "There's an estate car on our side of the road, pointing at us, and it keeps coming at a dawdle, as if reading house numbers.",
#:   "The opposing target occupies the VUT's own lane and advances in it contrary to the direction of traffic, at no more than 10 km/h.",
#:   "A tractor would have been quicker than that pickup, which was on my half of the road, coming at me, and simply didn't stop.",
#:   "The truck is driving in my lane in the inverse sense, so slow that one can walk next to it, but it advances always against me.",
#:   "At a snail's pace, and with a queue of hooting people before its radiator, a coach made its way up the lane reserved for those coming down.",
#:   "Attention all cars, elderly male in a saloon facing oncoming traffic in their lane, going dead slow but not stopping, he's still rolling towards them.",
#:   "I came round the bend and there was a car in my lane, front to front with me. The dear lady was hardly moving, I should say five or six miles an hour, but she was moving, and she carried on towards me as though it was her side.",
#:   "V2 was travelling eastbound in the westbound lane occupied by V1. Its speed, as determined from the video, was between 6 and 9 km/h and did not change. It came ever nearer to V1 in that lane, and its driver said she believed the road was one-way.",
#:   "Scenario wish: a bus driver has lost his way and is on our side of the carriageway, head-on to the vehicle under test. He's cautious about it, so he only inches along, but he goes on inching towards us and at no point comes to a standstill.",
#:   "Listen, I've seen wrong-way drivers doing a hundred; this one's the opposite. He trickled along in my lane with his face to me, in a big box lorry, first gear, warning lights going, and I could do nothing but watch him get bigger, very gradually.",
#:   "The fog had hidden it, and when they made it out it was a car in their own lane with its lamps upon them. It was creeping; it felt its way along the verge like a blind man along a wall, and it was creeping towards them.",
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
