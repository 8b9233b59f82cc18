#: description = "The rider ahead slows down almost to walking pace and turns off to the right."
#: rephrasings = [
#:   "The bike in front slows right down and creeps off to the right.",
#:   "The bicyclist slowed and turned right into a driveway ahead of Vehicle 1.",
#:   "bike ahead slows, turns off right",
#:   "The target ahead reduces its speed and leaves the VUT's lane by a right turn.",
#:   "The cyclist before us becomes very slow and goes right.",
#:   "A postwoman on her bicycle dawdles and makes for a gate on the nearside.",
#:   "The moped we follow all but stops and then bears off right.",
#:   "The delivery rider ahead eases off and turns into a yard.",
#:   "The girl on the bike in front dropped almost to nothing and turned off down a side street on the right.",
#:   "The bicyclist ahead reduced speed considerably and made a right turn off the roadway.",
#:   "MC ahead slows way down, off to R.",
#:   "The leading two-wheeler decelerates to near walking speed and leaves the road by a right turn.",
#:   "The bicycle before me becomes very slow and goes away to the right.",
#:   "Lead rider: decel to ~5 km/h then exits right; blocks us only while turning.",
#:   "He let the bike run down until it could scarcely stand up and then steered it off to the right.",
#:   "Motorbike ahead's looking for his turning, he's right down to a crawl, and there he goes, off to the right.",
#:   "scooter in front went super slow and turned right, finally",
#:   "The cyclist ahead dropped to a crawl and left by a turning on the right.",
#:   "He abated his speed until he was barely moving and then departed to the right.",
#:   "Front bike became very slow, almost walking, and then went inside right side lane.",
#:   "Slows up till he's nearly going backwards, then finally clears off to the right.",
#:   "Pronounced speed reduction of preceding two-wheeler ahead of right turn-off",
#:   "BIKE ALMOST STOPS, THEN TURNS RIGHT",
#:   "The cyclist in front dwindles to a crawl and ducks off right.",
#:   "Scooter ahead fades to footpace, then peels away rightwards.",
#:   "Let the leading cyclist ease nearly to a halt and take a right.",
#:   "Lead bike bleeding speed to jogging rate, exits on our right side",
#:   "The bicycle in front is going so slow like walking, then right side gone.",
#:   "Postie in front dropped to snail speed and right-handed into somebody's drive.",
#:   "The old boy on the pushbike in front of me let his speed run off till he was hardly pedalling, then steered himself away into a lane on the right.",
#:   "The preceding PTW brakes to about 5 km/h in the lane of the vehicle under test and departs from it by way of a right-hand turn.",
#:   "We were following a learner on a moped who slowed and slowed, feet dangling, until at last she tipped into the turning on our right-hand side.",
#:   "V2, a motorcycle traveling ahead of V1, reduced to approximately walking speed before negotiating a right turn out of the roadway.",
#:   "Before me the cyclist made himself very slow, I could have walked with him, and after this he went in the small street at the right.",
#:   "Could you put a rider in front of the robotaxi who loses nearly all his pace and then bears away to the right, still dawdling?",
#:   "She rang me afterwards quite cross about it. The lad on the bike in front of her had braked down until a toddler could have kept up, and at that same pace he rounded the corner to the right and went off between the houses.",
#:   "Watch the delivery rider ahead of us. He's looking at door numbers, so he'll slow, and there you are, he's at a stroll; now he's leaning to the right and he's off into that courtyard, so you can have your speed back.",
#:   "The motorcycle had led our little column for some miles. Near the mill its rider throttled down until the engine almost stalled, and then, unhurried, he guided it through the gap in the wall on his right and was lost to view.",
#:   "Use case: a two-wheeler travels in the ego's lane in front of it. It sheds speed to little more than a walk, which obliges the ego to follow suit, and then it swings off to the right at that same low speed, freeing the lane.",
#:   "Bike and me go way back, so no hard feelings, but I was in a loaded HGV. This fella in front on his racer comes right down to a walk, no arm out, and only then does he veer off into the farm track on our right.",
#:   "Motorcyclist in front winds down to a stroll, then peels right.",
#:   "Bike ahead: pace gone, then gone itself, right-hand alley.",
#:   "deliveroo in front went full zombie mode then wandered off down a right",
#:   "The moped that we had been following throttled back until I could count its spokes and then, no quicker, tipped into an entry on the right.",
#:   "The preceding cyclist decelerates to approximately 5 km/h and subsequently clears the lane of the VUT by turning off to the right at that speed.",
#:   "He was first my wind-breaker, this racing man, then he became so slow as a walking one and curved himself away to the right side.",
#:   "Could the motorbike in front lose its speed until it's about level with foot traffic, and only then round the corner to the right and leave us?",
#:   "On the bicycle ahead of us a vicar let his legs hang, sank to the tempo of a procession and steered through the lychgate on the right.",
#:   "V2, a bicycle preceding V1, slowed to what a bystander called \"a walk\" and then exited the roadway by a right turn into a driveway.",
#:   "I was behind this lad on his scooter all down the High Street at a nice twenty. By the bank he'd dwindled to the pace of the shoppers, which meant that I had too; and at that rate, wobbling a little, he bore off to the right into the alley and gave me my road back.",
#:   "What the camera caught was a rear reflector getting bigger. We gained on it faster than we meant to, since the pushbike it belonged to had come down almost to a foot pace; the reflector then slid away sideways past our right-hand headlamp and down a farm track.",
#:   "My husband said that a cow would have got out of the road sooner. The motorcycle before us had slowed until its rider was practically walking it, and the right turn into the campsite that followed was performed with the same solemnity, tent poles and all.",
#:   "Two things to spot. He's sat up, he's stopped pedalling, and we're catching him fast because he's hardly doing more than those two on the pavement. And he's peeking over his right shoulder at that gateway; yes, that's him leaving us, as leisurely as you like.",
#:   "The lead rider's exit took nine seconds from start to finish. For the first five it bled speed in front of the ego until it reached 1.5 m/s, and for the remaining four it described a right-hand arc at that same speed and left the carriageway.",
#:   "When at last I could go on, there was a thin wet tyre line on the dry road that swerved off to the right. A woman on an old bicycle had drawn it, ahead of me, after letting herself run so slow that the pigeons wouldn't get up for her.",
#:   "I'm the cyclist in this one, so be kind. I live up a lane on the right with a gravel corner that's had me off twice. I was in front of a taxi; I scrubbed off nearly everything, down to where I could have got off and pushed, and took my right-hander like an egg carrier.",
#:   "No signal was seen by the driver of the coach. He did see the motorbike ahead lose its way to such a degree that the rider had his boots near the tarmac, and then he saw it drift round to the right through the gates of the brewery, at the speed of a dray.",
#:   "Granny loves a postman. She wasn't at all cross that he had us down to his own dawdle, right in front of our bumper on his little electric bike, or that he took a good while to amble round to the right into number eleven's drive.",
#:   "The trouble with this scenario is patience. The bicycle ahead of the robotaxi loses nearly all its speed, and a hasty planner will want to shoot by on the right, when the right is exactly where the bicycle, still crawling along, is going to turn off.",
#:   "Front one was milk-seller with two cans on his cycle. He reduced, reduced, it was like he is walking beside his own cycle, and after that he took inside to the right, very soft, because of the milk, and I got my way.",
#:   "Bike ahead wilted to a stroll, then was away through the right-hand gate.",
#:   "Moped's pace collapsed before us; afterwards it crept off rightwards.",
#:   "Postie in front: walking speed, arm out, number nine on the right.",
#:   "With a van at his back he let the bicycle run out of puff till it wobbled, and only then did he point it into the lane on our right.",
#:   "We came down to five miles an hour because the motorbike before us had, and got our road back when it had trundled through the farm entrance, right-hand side.",
#:   "I'd like a two-wheeler in front to get so slow that a walker could keep up, and to take a right-hand exit from the ego's lane no faster than that.",
#:   "Hold back, he's nearly standing on those pedals; it's that drive he's after, the one on the right, and he'll be an age rolling round into it.",
#:   "Before departing the roadway by way of an alley to its right, V2, a scooter directly ahead of V1, had dropped to an estimated three miles per hour.",
#:   "The biker before me became so little quick that his boots made walking beside him, and after it he let himself to the right into the yard of the cheese factory.",
#:   "The gap shut without anyone having touched a brake that I could see. It was the girl's legs that did it: they had been going round on the bicycle ahead, then they hung. We were down to the pace of prams when her wheel at last began to come over to the right, and she floated out of our way into a mews.",
#:   "I can tell you the colour of his socks, red, and that's how long I had him before my bumper. He'd been a dot. He wasn't one by the time he had braked his motorbike down to a totter, looking for a hole in the hedge on the right; and into the hole he tottered, and I had a road again.",
#:   "What would you say that rear light's doing? It isn't braking, it's growing; so he's dying on us. There, we're at a walk. Now it's sliding across the glass towards your right-hand pillar, nice and slow. And now it's gone between two houses, and you haven't got anybody in front of you at all.",
#:   "On the ticket it says \"ego stuck behind bicycle, 8 s\". Five of them are explained by its slowing from eighteen to about five. The other three are its exit: a right-hand arc of small radius, at the same five, into a driveway. After that the lane's clear, and the ego picks up as it should.",
#:   "My late wife would've made me wait even longer, to let the poor woman get well in. She was on an old upright ahead of us, in a cape. She had the wind against her and had let it take off nearly all her way; so when she bore to the right, up the track to the kennels, you could see each leaf she rolled over.",
#:   "Whether he signalled is neither here nor there. The coach behind him had been brought down to foot pace by the motorcycle, as its tachograph confirms, a full four seconds before the machine's course altered. It altered to the right, towards the quarry gate, and it did so at that same pace, the rider's feet brushing the ground.",
#:   "My delivery app says \"right in 20 m\" and I always overshoot. So this time I shed the lot early, with a taxi breathing on me, till I could've been outrun by a gran. It tooted. I still took the alley on the right at gran speed, since the last time I'd met a bin in it.",
#:   "In the lorry you learn to see it in the shoulders. The rider of the moped ahead had put them down, and they'd stopped rocking, and our forty tonnes had to come right down the box to stay off his plate. His shoulders leant to the right by about an inch. That took him, at the speed of a tired dog, into the caravan park.",
#:   "The wheel ahead of theirs had all but ceased to turn; one could have told its spokes. So for some yards the motor went behind the boy like a governess. There was a white gate on the right hand. Towards it, with the gravity of one who carries eggs, and in fact he carried eggs, the boy let himself be borne, and they were free.",
#:   "Comment thread: why doesn't the AV just go round him on the right? Because watch. He's leading, he's killing his speed, he's at pedestrian tempo at 0:09, and at 0:11 the handlebars go over. To the right. At 0:14 he's still only halfway into the alley. You'd have gone right into him.",
#:   "Before me one newspaper boy on cycle. First he was going like wind. Then like train. Then like bullock, so I also like bullock, and behind me all Chennai like bullock. I'm putting horn. He is showing right hand. To the right there is one small gate, and into that, like honey from spoon, he went.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["slow", "turn-right"]
#: position = "ahead"
#: place = "road"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.6
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 18.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 0.7
#: high = 1.4
#: unit = "m/s"
#: meaning = "how fast it turns"
#: [[parameters]]
#: name = "OPT_TURN_RADIUS"
#: low = 3.0
#: high = 5.0
#: unit = "m"
#: meaning = "the radius of its turn"

param OPT_BRAKE = Range(0.6, 1)
param OPT_ADV_DISTANCE = Range(0, 18)
param OPT_SLOW_SPEED = Range(0.7, 1.4)
param OPT_TURN_RADIUS = Range(3, 5)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego, 4) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < globalParameters.OPT_SLOW_SPEED
    do TurnOff(-1.5, globalParameters.OPT_SLOW_SPEED, globalParameters.OPT_TURN_RADIUS)
    do MoveAhead(globalParameters.OPT_SLOW_SPEED)
