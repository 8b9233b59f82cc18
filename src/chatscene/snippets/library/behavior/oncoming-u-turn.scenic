#: description = "The oncoming car makes a U-turn in front of the ego."
#: rephrasings = [
#:   "he's coming the other way and just swings round right in front of us",
#:   "Vehicle 2, travelling in the opposite direction, executed a U-turn ahead of Vehicle 1.",
#:   "opposing veh, U-turn across our lane",
#:   "The oncoming target turns through 180 degrees into the lane of the VUT.",
#:   "A taxi from the contrary direction turns around and drives then in our direction.",
#:   "A biker facing us does a one-eighty and ends up ahead.",
#:   "The police car opposite whips round to go after somebody.",
#:   "Coming toward the ego, it spins about and carries on the way we are going.",
#:   "the cab coming the other way spun right round in front of me to go back where he came from",
#:   "The oncoming vehicle made a U-turn directly in front of V1.",
#:   "MC opp.: 180 right before us.",
#:   "The oncoming target reverses its direction of travel by a U-turn ahead of the VUT.",
#:   "The police from front turns around before me and drives then in my direction.",
#:   "Opposite NPC flips heading by 180° ahead of the SUT and ends up in our lane, same way.",
#:   "It had been coming to meet them; it swung about full circle under their bonnet and showed them its tail lights.",
#:   "That car's decided he's going the wrong way, he's flipping it round in the road right in front of you.",
#:   "the car coming at us just flipped a full 180 right in front of us",
#:   "An approaching patrol car spun about before traffic and set off the way it had come",
#:   "You reversed your direction entirely, did you not, under the nose of my client's oncoming car?",
#:   "Opposite bike suddenly took U-turn in front of us only, no sense",
#:   "He's coming towards me, changes his mind about the whole journey and swings it right round under my bumper",
#:   "About-turn of opposing traffic in front of own vehicle",
#:   "Oncoming car pulls a FULL 180 right in my face",
#:   "The taxi facing us pivoted about before our bonnet.",
#:   "Opposing taxi doubles back before our nose, now heads our way.",
#:   "Oncoming scooter: half-circle into ego lane, continues in ego direction.",
#:   "He was driving at us, then he turned round and drove away from us.",
#:   "COP DOES 180 IN FRONT OF ONCOMING ROBOTAXI",
#:   "Can't a saloon coming the other way find a better place to turn round?",
#:   "I need an opposing hatchback which, when the subject vehicle is near, swings through half a turn into its lane and goes on ahead of it.",
#:   "Bonnet first it came towards me; boot first it left, since the Audi had spun itself round right across the front of my cab.",
#:   "The approaching ambulance received a new address, evidently, as it wheeled about in the road before us and made off the way we were going.",
#:   "From the contra side comes a moto, it gives a half tour on the road before my nose and is then before me, same sense.",
#:   "V2, initially eastbound and opposing V1, reversed its heading in front of V1 so that both vehicles were facing west when they made contact.",
#:   "Oncoming SUV's missed his turning, I reckon; he's throwing it about in the road ahead and he'll come out of it leading you.",
#:   "Lost tourist, most likely. I could see the hire car coming up the other side with its driver peering at a map, and when I was nearly on him he swung the wheel hard over, came about in front of me, and carried on in my direction.",
#:   "The target starts in the opposite lane. At the specified gap to the subject vehicle it turns through half a circle towards that vehicle's lane, and on completion of the arc it proceeds along the lane, now with the same heading, at its nominal speed.",
#:   "Everybody in the squad car was looking at the stolen bike behind us, not at us. They were coming towards us, and then blue lights, a howl of tyres, and they had flung the car about under our noses to go back up the road we were taking.",
#:   "My father taught me never to trust a motorcyclist who slows and looks behind him. This one was riding up to meet us, and sure enough, he heeled over, came all the way about in front of the grille, and went off up our lane.",
#:   "Ticket 902: an oncoming agent that does a one-eighty into our lane is still predicted as opposite traffic till the arc is complete. It begins in the other lane facing us and ends in ours facing away, and between those two we brake far too late.",
#:   "Approaching SUV pivots right round ahead of us and leads off.",
#:   "Head-on scooter about-turns on our doorstep, then goes our way.",
#:   "Oncoming police car: full turnabout before our nose, same heading.",
#:   "The minicab that had been coming up to meet us was, after one long squeal of lock, the minicab in front of us.",
#:   "Let an ambulance that comes towards the ego change its mind, describe a half circle before it, and proceed in the ego's own direction.",
#:   "That saloon's heading for you, then it isn't: it has come right round in the road and you're looking at its boot, so slow down.",
#:   "He rode in my direction, opposite I mean, and of a sudden he has wended his moto by hundred eighty degrees directly before my car.",
#:   "Motorist who was travelling towards a hospital bus turned his vehicle completely round in its path and drove off ahead of it, police say",
#:   "Control, suspect's Focus was oncoming to us, he's clocked us, thrown it about in the road right in front and he's now making off our way.",
#:   "I ask my learners to name the vehicle that could hurt them most. They all choose the lorry behind. It was the hatchback on the other side, coming our way with the driver on the phone. She'd missed the garden centre, so she looped right round under our noses, and then dawdled along in front as though she'd always been there.",
#:   "The tracks in the snow were easy to read. One pair of wheels had come along the opposite side as far as the bus shelter; from there they curved over to our side in a single bow, without a break for reversing, and went off in the direction we were driving in. We had only just stopped short of the bow.",
#:   "V2 was initially proceeding east and V1 west. With V1 at a distance estimated as five car lengths, V2's operator, who was following a sat nav, brought his vehicle about in front of V1. When contact was made both were facing west, V1's front having met V2's rear, which gave the first officer the wrong idea altogether.",
#:   "A motorbike facing us is worth a glance and no more, one would think. But the headlamp I had glanced at was, at the second glance, a saddlebag, at the third, a tail lamp. He'd spun the thing about between the white line and our radiator; and it was at his back wheel that I stared for the rest of the way.",
#:   "Requirement: the system shall cope with an opposing vehicle that reverses its course ahead of it. Stimulus: the opposing vehicle, in its own lane, commences a turn on small radius towards the lane of the ego, sweeps through 180 degrees, and then continues in the ego's lane, in the ego's direction, at its own chosen speed.",
#:   "We thought the ambulance was going to pass on the other side, you see, so nobody in our car said anything. Then I suppose they got told on the radio that the poor soul was up the other end. It wheeled round right there in front of us, like a horse would, and off it hurried with us behind it.",
#:   "Ghost target again in run 31. The tracker deletes the oncoming car at 22 m and creates a new lead car at 14 m, three seconds afterwards. There's only the one car, it's got a roof box in both. It turned round, in one sweep, from its side to ours. We braked for the second one but not for the turn.",
#:   "Okay guys storytime. Empty street, one Tesla coming at me, me in my mum's Clio. We're about to pass each other like normal people. He whips it ALL the way round in front of me, tyres screaming, and takes off down my side the same way I'm going. My mum's Clio has no brakes worth mentioning.",
#:   "They had been warned of a checkpoint by other drivers flashing. The one that was coming up towards us was warned too late, I think, since he jerked his estate round through a half-turn when there was scarcely room between us, and where there had been two headlamps in my eyes were two red lamps and a cloud of blue smoke.",
#:   "Your Honour asked how my client could run into the back of a car that was coming towards her. It is a fair question. It wasn't coming towards her by then. It had been, until it was a few yards off. It had at that point swung right about, and it was in her lane, going her way, and slowly.",
#:   "In my country the police makes so every day, but I did not know that also here. The patrol comes from the opposite, calm, they look on me. I look on them. Then with blue light they make the half circle in front of my truck and are driving before me, in the same direction, after some Audi.",
#:   "Grille, flank, tail lights, all in our lane, all one SUV.",
#:   "Approaching biker flipped about before us and became our leader.",
#:   "Ambulance facing us went right round, then led us away.",
#:   "We'd been about to meet that squad car; after its twirl across the road before our bonnet we were following it.",
#:   "Make the opposing taxi come round through a half-circle in front of the ego, to end up in the ego's lane with the ego's heading.",
#:   "A second ago I could see his face, and now it's the back of his head; the pickup that was coming at me turned right round ahead.",
#:   "For V1, the headlights of V2 became tail lights at a distance of fifteen metres, V2 having turned through half a circle before it.",
#:   "How's he going to explain that he was going to Leeds, met you, spun about in front of you, and was ahead of you going to Hull?",
#:   "The moto in front comes to us, and then makes the complete turn under our eyes, and it drives where we drive, before us.",
#:   "\"Forgot my phone\" was what he gave as a reson. He'd been heading out of the village, we'd been heading in. His was the only other car on the road. So why did we have to brake? Because the road in front of us was where he brought it round, hard left lock all the way, to head in himself.",
#:   "My daughter asked why that car had two fronts. It hasn't, love. You saw its front, for it was driving towards us. Then it went sideways over our bit of the road, spinning round as if on a plate, and it was its back that you saw after, with the little dog in it, going along before us.",
#:   "Sometimes the best lane-keeping isn't enough. Our car was in its lane; the opposing scooter was in its own. At twelve metres the scooter's yaw rate shot up, it traced an arc into our lane, and it didn't quit tracing when it was square to us. It ended up as our lead object, same heading, range four metres.",
#:   "Sirens are directional, so I noticed before my fare did. We could hear the fire engine coming to meet us, wow-wow, louder and louder. Then it was lengthways over the street in front of the cab, deafening. Then it was ahead of us, going in our direction and getting quieter. It'd been sent to the wrong end of town.",
#:   "Three-point turns I've no quarrel with, they give you time. She did it in one. There's the whole width of Park Lane to do it in, provided that nobody's using the other half, and I was. So her Mini, which had been coming from the park, skimmed round across my radiator and scampered off towards the park.",
#:   "What the tacho disc can't show is why I stood on it. It was a kid on a 125 coming from the opposite way who'd seen his mates go by. He dropped the bike on its side, near enough, and scraped it about in front of my wagon, so that in the end it was me that had him in front, tail lamp and all.",
#:   "The witness was asked to place two model cars on the plan. She placed them nose to nose, on either side of the white line. Next she took the red one and drew it, with her finger, in a horseshoe over the line and before the blue one. When she let go, both were pointing at the jury, the red one leading.",
#:   "My rule on this job is look for the brake lights. With that van there were none to look for, it was coming at us. I looked away. When I looked again, there they were, big and red, on the same van, in our own lane, which it could only have got into by whirling right about in front of us.",
#:   "Strictly, said the examiner, that wasn't our lesson for the day. He'd had to use the dual controls. The cab in question had been approaching on its own side with its light on; some gentleman had whistled behind us, no, ahead; and cab and light described a smart semicircle under our bumper and dashed off ahead of us.",
#:   "The target commences on the opposite side, heading towards the subject vehicle. When the remaining gap falls below the threshold it is steered with a radius of 3.5 m until its heading has changed by nearly 180°, all within the subject vehicle's field of view and partly within its lane. It then proceeds along the subject vehicle's route.",
#:   "Stuck in my head like a song: whoosh of tyres, his, coming. Screech of tyres, his, turning. Screech of tyres, mine. Whoosh of tyres, his, going, and in the direction that I'd been going in, which is how I could read out his number plate to you. I've never been overtaken by somebody from the front before.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "u-turn"]
#: position = "oncoming"
#: maneuver = "straight"
#: leader = false
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 6.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 22.0
#: high = 42.0
#: unit = "m"
#: meaning = "distance to the ego at which it turns round"

param OPT_ADV_SPEED = Range(4, 6)
param OPT_ADV_DISTANCE = Range(22, 42)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do TurnOff(2.9, globalParameters.OPT_ADV_SPEED, 3.5)
    do DrivePath(egoRoute, globalParameters.OPT_ADV_SPEED)
