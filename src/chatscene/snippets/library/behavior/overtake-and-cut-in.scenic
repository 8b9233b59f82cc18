#: description = "The car overtakes the ego and cuts in close in front of it."
#: rephrasings = [
#:   "He blows past us and tucks in right under our nose.",
#:   "Vehicle 2 passed vehicle 1 and returned to the lane with insufficient clearance.",
#:   "Overtakes, then tight merge before us.",
#:   "The target passes the VUT in the adjacent lane and cuts in at small longitudinal distance.",
#:   "He overtakes and comes in too early, almost touching our front.",
#:   "A lorry grinds by us and pulls back in before its tail is clear.",
#:   "The coach passes and crowds us off as it returns.",
#:   "A motorbike comes from behind, gets by and drops in at arm's length.",
#:   "some BMW flew past me and chopped right back in under my nose",
#:   "The vehicle passed V1 and moved back in directly ahead with minimal clearance.",
#:   "MC passes, tucks in v. close.",
#:   "The target passes the VUT and returns to the lane at a very small longitudinal distance, keeping its speed.",
#:   "The motorbike goes by me and comes back very near before my car, then drives on.",
#:   "Pass-and-tuck: overtaker re-enters the ego lane with almost no clearance; no braking required.",
#:   "It had drawn by on the outside and then shouldered in so close that they could read its tax disc.",
#:   "He's gone by you and pulled back in far too early, he's nearly clipped your wing, but he's away.",
#:   "he overtook us and pulled in SO close i could read his stickers",
#:   "A motorcyclist swept by a learner and tucked in barely a foot ahead of her",
#:   "You passed my client and regained the lane with scarcely any room before her bonnet, but you did not brake?",
#:   "He overtake us then squeeze in front so near, almost kiss my bumper",
#:   "Comes round me, tucks in with a fag paper between us and swans off",
#:   "Overtaking with insufficient clearance on return to lane",
#:   "Motorbike overtakes and nearly clips my FRONT BUMPER",
#:   "The coupe leapfrogged us and shaved our nose.",
#:   "goes by us and drops back in waaay too tight",
#:   "Motorcyclist passed, then squeezed himself between us and nothing.",
#:   "Overtaker returns to our lane with barely a car's length.",
#:   "CLOSE SHAVE: SUV passes and chops across our nose",
#:   "The cab went past and folded in hard on our bumper.",
#:   "The saloon came up on the outside, passed the AV and returned to the lane so early that its rear bumper all but brushed the AV's wing.",
#:   "I'd like a fast car to come from behind, go past us in the next lane, and then take our lane again with next to no clearance.",
#:   "Having gone past, the target vehicle re-enters the lane of the VUT at a time gap of less than half a second and maintains its speed.",
#:   "Why did he have to come back in so soon, when he had the entire road ahead of me to finish his pass in?",
#:   "A motorbike which was behind has doubled us and has folded back just before our bumper, I could have touched it with the hand, and it continued.",
#:   "Two feet, no more, was what the van left us when it slid over in front of our bonnet after it had gone by.",
#:   "A people carrier came past me on the motorway with its box on the roof. Most people would have waited till they could see both my headlamps. She didn't, she pulled over into my lane the moment her tail was clear, and then carried on at speed.",
#:   "Vehicle 2 passed Vehicle 1 in the adjoining lane at a speed difference of some 20 km/h. It then moved laterally into the lane of Vehicle 1 with a bumper-to-bumper distance of about two metres, did not brake, and continued along the lane ahead of it.",
#:   "For the cut-in series please vary the clearance. The car approaches from the rear in the left-hand lane, gets ahead of the test vehicle and immediately comes across in front of it, close enough to violate the safety distance; after that it just drives on.",
#:   "You've done nothing wrong there. That motorcyclist went round you, which is his right, but then he came in on you when he was hardly past your front wheel. Ease off a touch and let your gap grow again; he's away up the road now.",
#:   "So there I am, bimbling along, and this Golf comes by me. Fair enough. Only he's still about half alongside in my head when he's already over in my lane, and I am staring straight at his tailgate. Never slowed, never waved, just trundled off ahead.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: passing; own code"
#: [slots]
#: actions = ["overtake", "cut-in"]
#: leader = false
#: maneuver = "straight"
#: position = "behind-beside"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 11.0
#: high = 14.0
#: unit = "m/s"
#: meaning = "how fast it overtakes at most"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 0.5
#: high = 6.0
#: unit = "m"
#: meaning = "how far ahead of the ego it is when it moves over"

param OPT_ADV_SPEED = Range(11, 14)
param OPT_ADV_AHEAD = Range(0.5, 6)

behavior AdvBehavior():
    do DrivePath(advLane, globalParameters.OPT_ADV_SPEED) until headway(egoRoute, ego, self) > globalParameters.OPT_ADV_AHEAD
    do DrivePath(egoRoute, 8)
