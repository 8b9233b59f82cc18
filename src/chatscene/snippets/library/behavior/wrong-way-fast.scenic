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
#:   "Ghost rider in our lane, coming at a hundred plus.",
#:   "Oncoming sedan, contraflow in ego's lane, very high velocity, no yielding.",
#:   "He's on our side of the road and he's absolutely caning it.",
#:   "Why is a Porsche rocketing towards me in MY lane?",
#:   "A motorbike came at us super fast on the side where we drive.",
#:   "I want a getaway car that comes from the front at top speed, in the ego's lane, against the direction everybody drives in there.",
#:   "What I saw was two headlamps dead ahead, in the lane I was in, getting bigger quicker than anything I've ever seen.",
#:   "V2 was traveling southbound in the northbound lane occupied by V1, at an estimated ninety miles per hour, and took no evasive action.",
#:   "A Geisterfahrer with an enormous speed was on my own lane against me, I had only to pull the wheel and to pray.",
#:   "Get left, get left, there's a wrong-way Subaru heading for you in lane two and he must be doing a ton.",
#:   "Closing speed was the killer: the biker opposing us was in our lane from the start and had the throttle pinned.",
#:   "My old heart nearly gave out. We were pottering along to the garden centre, the two of us, and towards us, on our side of the dual carriageway, came a silver motor car at such a speed that it was there and gone by before I could say Jack Robinson.",
#:   "Frontal encounter, high energy. The opposing vehicle uses the lane of the subject vehicle in the forbidden direction and maintains a speed well over that of the surrounding traffic. It neither slows nor goes back to its side; avoidance is left to the subject vehicle alone.",
#:   "The suspects, chased by three units, had gone up the exit ramp. From then on they were barrelling along in the lane of the people who were heading home from the match, facing all of them, at a speed the pilot of the helicopter put at 160 km/h.",
#:   "On the tape there's a dot in the middle of the AV's lane, way off where the road meets the sky. Two seconds on, the dot is a motorcycle. One more and it fills the picture, head-on, its rider flat on the tank and going like a bullet.",
#:   "I've been driving artics on the autobahn since the Wall came down, and I've met wrong-way drivers, mostly confused old folk. This one wasn't confused. He was in my lane, facing me, full beam, and hammering on as if he had the whole road to himself.",
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
