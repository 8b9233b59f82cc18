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
#:   "Sedan screaming up our lane against us, nowhere near letting off.",
#:   "Motorbike on the wrong side, our side, head-on, doing warp speed.",
#:   "Opposing hot hatch owns our lane and is going ballistic.",
#:   "That cabbie was driving in my lane, in the direction you mustn't, and not at a lost pensioner's pace but like a man late for his own wedding.",
#:   "Make the convertible rush towards the ego at the highest speed allowed, inside the ego's lane, without ever going back to its own.",
#:   "Two bikes in the wrong carriageway, repeat wrong carriageway, lane one, coming at you at well over the ton, get yourselves behind something solid.",
#:   "The taxi, he rides in inverse sense on my voie, the foot to the plancher, I have seen only the two big eyes of his phares.",
#:   "Whoever it was in that Audi, they had our lane, they were facing us, and the way they were shifting you'd have thought it a runway.",
#:   "Closing at a combined 230 km/h, Vehicle 2 was travelling against the direction of traffic in the lane used by Vehicle 1, with no braking and no avoidance.",
#:   "In all my years with the coach firm I've had one real fright. It was four in the morning, an empty motorway, and I'd a hen party asleep. Two headlights where there should be tail lights, in my own lane. I thought, a long way off, plenty of time. There wasn't any, because of how hard he was driving. He went by like a shell.",
#:   "\"You can tell a drunk from a madman by the speed,\" the old sergeant used to say. Drunks who've come up the slip road in error potter. What we had in front of us, in the lane we were on, nose towards us, was not pottering. It was a silver coupé at a hundred and thirty and it had no intention of leaving.",
#:   "I'll always remember how quiet it was. A warm evening, my pupil doing forty, hands at ten to two. Then a noise like tearing cloth, and up our side of the road, towards us, a motorbike so quick that my foot hadn't reached the pedal before he was on top of us. He hadn't strayed there. He was simply using our half.",
#:   "Conditions: dual carriageway, night, dry. The opposing vehicle is placed 300 m ahead in the lane of the subject vehicle, facing it. On start it takes up its maximum speed, which it holds till the two are past each other. Since there's no deceleration on its part, time to collision at first detection will hardly exceed four seconds.",
#:   "There had been a robbery, we learned later. It explained the speed; it explained why they cared so little what side they were on. All we had at the time was the view along our own lane, with a black van in it, front end on, that had been a speck at the bridge and was the size of a house by the second lamp post.",
#:   "Perception says the oncoming track is in our lane and it's right. What it gets wrong is the speed: it's clipped to 40 m/s, since someone thought that nothing would come at us quicker. This thing does 48, head-on, against the flow, and is not overtaking anybody. Please lift the limit and rerun the evasive manouvre with the true value.",
#:   "Asked by the prosecutor why she had driven into the ditch, the district nurse said that the ditch was the only place in which the accused was not. He was in her lane. He was facing the wrong way in it. And he was coming so fast, she said, that by the time she had thought all this she was in the ditch.",
#:   "\"Somebody's on our side,\" said the boy, and then, since no one answered, \"he's going really fast.\" His father had been feeling for his sunglasses. What he found when he looked up was a chrome grille straight ahead, where the empty lane ought to be, coming on like a thing dropped from a height, with no driver to be seen behind the glare.",
#:   "One-way street, mind you, with a sign as big as a barn door. We're trundling up it in the bin lorry. Round the bend at the top comes some kid on a superbike, so he's in our lane, there's only the one, and wrong way. He's not creeping down it looking sheepish either. He's got it howling in third and he's aimed at us.",
#:   "Sir, the truck people at least put light when they are coming in wrong side. This Fortuner put nothing. I was in my own lane, correct direction, sixty. He was in my own lane, wrong direction, I am thinking hundred forty, and he didn't give one inch till he had gone from there. God has driven my car at that moment.",
#:   "wrong way guy on the 405 and before you say \"probably some confused grandma\", watch the lane markers. hes eating them. in the cammers lane, coming straight at the cammer, literally faster than anything going the right way. doesnt flinch doesnt brake doesnt move over. from dot to windshield in 3 sec",
#:   "Headlights in our lane, facing us, eating up the road.",
#:   "Biker coming the forbidden way, our lane, throttle to the stop.",
#:   "Opposing car owns our lane at a hundred and fifty.",
#:   "The speck that I'd taken for a tail light in my lane was a headlight, and a speck it remained for about one second.",
#:   "Give the sports car full power and the ego's lane, put it nose to nose with the ego, and don't let it leave.",
#:   "i was in my lane he was in my lane i was going one way he was going the other and he had it flat to the floor",
#:   "Radar shows a closing speed of 260 km/h in the AV's own lane, less than a third of which was contributed by the AV.",
#:   "Did you see him lift, or drift back to his half, at any time while he came blazing down yours to meet you? Neither.",
#:   "He was rolling à contresens, in my file, at I don't know how much, I have only had the time to throw me in the ditch.",
#:   "What the passengers remember is a star. It stood low over the road, right in the middle of our side, and one of them remarked on how bright it was for the time of the year. In the time it takes to remark on it, the star had turned to a pair of lamps with a BMW behind them and a howl coming off it.",
#:   "I've done the arithmetic since, to get to sleep. He'd come up my side of the dual carriageway from the far roundabout, that's 600 metres. I saw him at 400. From there till I was in the barrier I'd said \"what is that\", no more, and you don't say it slowly. It works out at something like a hundred miles an hour.",
#:   "Three drivers ahead of me had opened up like a zip, to left and right, and I couldn't see for what. Then I'd got no one left ahead of me and I could. A motorbike, coming through where we'd all been driving, the opposite way to all of us, front wheel light, rider flat on the tank. I made the fourth.",
#:   "Every rule says keep left, and I was; it says nothing about what to do when a hot hatch is using the same left, from the other end, with its rev counter in the red. It didn't flinch. Its flashing lights got nearer as quick as a slap. I went for the verge, Your Worship, and I'd go for it again.",
#:   "This is the nastiest of the head-on family. A car that crawls at you in your lane can be avoided by stopping, and one that pulls out to overtake goes in again. Here the opposing vehicle accelerates with everything it has, stays in the subject's lane until the end, and leaves no more than three seconds. Stopping does not help. Going aside does.",
#:   "Traffic news, and if you're on the bypass between Otley and the hospital, southbound, get off the thing. There's a black Audi northbound. I'll say that again, on your side, in your lane, headed at you, and a listener who's in the ditch by the golf club reckons he was doing twice the limit as he went by her.",
#:   "The first thing to reach us was its noise, a thin scream as of a wasp in a jar. \"From behind,\" I said, and looked into the mirror, because that's where fast bikes come from. It was my pupil who looked ahead. It was there, in front, in our very own lane, on one wheel, getting huge. I've never turned a steering wheel so hard.",
#:   "Ghost driver in Germany is normally a grandfather with fifty, he's confused. You see him far, you make place. This one wasn't confused and had not fifty. I drive 90 in my lane. On the same lane, from the opposite, light, light, LIGHT, wind, and my mirror is away. The police has measured him two kilometres later with 187.",
#:   "Snow makes honest tracks. My van's go along the right-hand side, where they should, and then dive off it into Mr Lund's field. His are on that same right-hand side, right on top of where mine would have been, but his treads point the other way; and from the length of the spray at each bump the constable worked out ninety plus.",
#:   "A boy racer's moped it wasn't, this was a thousand cc with somebody's grandson on it. Contraflow, up the bus lane that my bus was in, no lights, chin on the clocks. I hooted. You can't hear a hoot at that speed. Everything I've got I gave to the kerb side, and he came through what was left like a bullet.",
#:   "The oncoming track was initialised at a range of 210 m with the lateral position of our lane centre, and we discarded it as a reflection, since in our lane and at minus 48 m/s nothing legal could exist. The reflection was a Porsche. It never deviated, nor did it decelerate. We now keep such tracks, and this is the regression case.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "wrong-way", "fast"]
#: position = "oncoming"
#: maneuver = "straight"
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
