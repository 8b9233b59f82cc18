#: description = "The cyclist ahead sprints off, tires and slows to a crawl."
#: rephrasings = [
#:   "The bike in front stands on the pedals, runs out of puff and crawls.",
#:   "The bicyclist accelerated and subsequently slowed to a very low speed ahead of Vehicle 1.",
#:   "cyclist ahead sprints, then fades to crawl",
#:   "The bicyclist target accelerates and then drops to low speed ahead of the VUT.",
#:   "The cyclist before us goes first fast and then has no power any more.",
#:   "A schoolboy pedals like mad until his legs give out.",
#:   "The weekend racer we follow blows up and dawdles.",
#:   "Her chain slips after a spurt and the bike ahead barely moves.",
#:   "the cyclist in front went off like Bradley Wiggins and then ran out of puff and was barely turning the pedals",
#:   "The bicyclist ahead of V1 sprinted, became fatigued, and slowed to a very low speed.",
#:   "Cyclist ahead: sprint, out of breath, then snail's pace.",
#:   "The bicyclist ahead of the VUT accelerates strongly and then falls progressively to minimum speed.",
#:   "The cycle man in front goes very fast, then he has no more power and goes very slow.",
#:   "Bike lead with exhaustion profile: peak speed first, gradual decay down to just-upright pace, never zero.",
#:   "He had stood on the pedals and flown ahead of them, but his legs gave out and soon he was barely turning them.",
#:   "He's giving it some welly on that bike... and he's blown up, legs have gone, he's just about staying upright ahead of you.",
#:   "cyclist in front went turbo mode then ran out of battery lol now its so slow",
#:   "A pensioner on a bicycle put on a burst before flagging to little more than walking pace",
#:   "You set off vigorously, then tired, so that those behind you were barely moving?",
#:   "Front cyclist first go so fast like race, after that no stamina, slow until like walking",
#:   "He's off like Bradley Wiggins for fifty yards, then his legs go and I'm stuck behind him wheezing",
#:   "Initial sprint of leading cyclist followed by fatigue-related decline to very low speed",
#:   "Cyclist sprints... then COMPLETELY runs out of steam",
#:   "The cyclist ahead surged, wilted and plodded.",
#:   "Cyclist in front bursts away, tanks, and is now barely rolling.",
#:   "Bike up ahead: big kick, lungs gone, reduced to dawdling, over.",
#:   "Have the pedaller in front charge off and then flag to near nothing.",
#:   "El ciclista delante attacks like in the Tour, then he is muerto, very slow.",
#:   "My big brother zoomed ahead on his bike and then got puffed, sooo slow.",
#:   "Stung by my horn, the boy on the racer ahead pumped his legs for all he was worth, but it couldn't last, and presently he was down to a dribble.",
#:   "The bicyclist target ahead of the VUT shall surge to 25 km/h for 4 s and thereafter, representing fatigue, proceed at 6 km/h.",
#:   "She'd darted off in front of the bus like a champion, yet fifty yards on her strength deserted her and we were trailing along at her new, feeble pace.",
#:   "A cyclist's early dash for the lights, carried out ahead of our robotaxi, ended in exhaustion and a rate of progress that pigeons could have matched.",
#:   "What you've got there is a rider with more heart than lung; he's leapt ahead of you, now he's spent, so expect to close up on him quickly.",
#:   "At length the bicycle before them was scarcely turning its wheels, its owner having squandered all his wind upon that first magnificent gallop.",
#:   "I know the feeling, because I cycle too. The man in front of the car gave it everything from a rolling start, out of the saddle, elbows going, and opened up a good thirty metres. Then you could see the battery go flat: he sat down, drooped, and hardly had enough left to stay upright.",
#:   "Following distance collapsed in this log although the ego never sped up. The lead bicycle put in a hard effort and pulled clear, we resumed set speed, and then the person on it ran dry and dropped to something like four km/h. They kept moving, feebly, and we came up on them fast.",
#:   "From my lorry I had a lovely view of the young gentleman in Lycra ahead. He heard the engine, didn't fancy me behind him, and shot off up the road as if there were a medal in it. Halfway up the bank he'd shot his bolt, and from there I had him at a plod.",
#:   "I'd like a bicycle in front of us that overestimates itself: it starts with a furious burst so that it gets away from the car, holds this for several seconds, and then, being worn out, goes along so weakly that we would catch it at walking speed.",
#:   "In the evidence of Mrs Rao, the delivery boy on the cycle ahead suddenly began pedalling very strongly and went well in front of her car. After some time he had become fully tired, sir, and he was moving his pedals with such difficulty that even people walking were leaving him behind.",
#:   "Bike in front: champagne start, flat beer finish.",
#:   "Lad ahead pedals furiously away, gets puffed, barely turns the cranks now.",
#:   "Cyclist leading: burst of power, empty lungs, tortoise pace, still rolling.",
#:   "Always the same with Sunday heroes in front of my bus, off they fly like swallows, and two hundred metres later I'm admiring their heaving backs at a trot.",
#:   "The leading bicycle's speed jumps at the trigger to seven metres per second, lasts as long as a tired man's legs do, and sinks to one and a half.",
#:   "Between the bakery, where she had shot clear of us, and the bank, where she could hardly push the pedal, the strength of the cyclist ahead had run out.",
#:   "Was he showing off, that boy on the bike in front, tearing ahead as he did before the hill turned him to jelly and his speed to a stroll?",
#:   "The pedalling man before my truck is first a rocket, he makes distance from me, and then he's an old donkey, he can no more, he goes at foot's pace.",
#:   "V1 was following a bicyclist who put in a vigorous spurt, opened the interval, and afterwards, visibly spent, dropped to a speed barely sufficient for balance.",
#:   "I'd been giving him two lengths. He looked over his shoulder, saw a Volvo, and I suppose he took it as a challenge, because he'd soon made the two lengths into ten. I put my foot back down, gently. And here was the Volvo coming up on him much quicker than I liked, since there was no more stamp left in those legs.",
#:   "In cycling they call it the man with the hammer. You could tell exactly where he was waiting, it was by the second milestone. Up to there the woman in front of our team car had gone clear in a beautiful effort. After it her head was down, her mouth was open, and she was doing a speed at which the mechanic got out and walked.",
#:   "My nephew is strong, but he is strong for only one minute. On his new cycle he was ahead of our auto, and he told, uncle, see me. Truly he went like an arrow. Then the arrow fell. When we came near he was so slowly moving the feet that the dogs, who had also run, sat down to wait for him.",
#:   "The point of the scenario's in the second half. Anyone can follow a bicycle that accelerates away. The trouble begins when it's ten metres further off than it was, the ego has sped up to match, and the person in the saddle has burned everything they had and is only just rolling, at a quarter of what they were doing.",
#:   "I heard the horn, and I'm not proud of it, but I thought, I'll show you. I was in front of the lorry, on my old racer. I got out of the saddle and I went, I honestly went, for about as long as it takes to boil an egg. Then the lights went out. I was panting like a dog and the lorry was at my back, waiting.",
#:   "Cross-examined, the van driver insisted that he had never accelerated towards the bicycle. It was the bicycle that had come back to him. Having flown off up Station Hill as though stung, it had, in his phrase, \"run out of boy\", and its rider was by then treading the pedals round one at a time.",
#:   "She had a letter in her basket and a train to meet, so she stood up and she rode; the car behind saw her dwindle to a spot of blue. But a letter weighs, and so does a summer with no breakfast. The spot grew again. It was toiling along beside the wall when they came up with it, hardly faster than the shadow of the wall.",
#:   "Look how far off he's got in just a few pushes. Tempting to go after him, isn't it? Don't. Nobody keeps that up on a bike with a child seat. There, the shoulders have gone, the knees have gone out sideways. He'll be at walking speed in a second and you'd have been right in his back wheel.",
#:   "Clip of the day is titled \"Main character syndrome\". A guy in full Lycra is in front of the camera car. He glances back, drops two gears and goes for the imaginary finish line. The cammer laughs. Cut to twenty seconds later and he's practically stationary but not quite, elbows on the bars, crawling, and the cammer's still laughing.",
#:   "Sensor fusion had the lead bicycle at 28 km/h at its best and at 5 km/h at its worst, and the entire decline happened inside our reaction horizon. The explanation is physiological rather than electronic. People tire. This one had spent himself in getting away from us and had only enough left over to keep the wheels going round.",
#:   "There's a stretch where the canal wind hits you full in the chest. So I wasn't surprised. The student on the bicycle ahead had whizzed off from in front of my taxi with her scarf straight out behind her. At the bridge the scarf came down. By the lock she was doing the sort of speed you'd do in treacle, and I crept along in her wake.",
#:   "Bike ahead: bullet for a block, slug from there on.",
#:   "cyclist in front went beast mode for like 5 secs now hes dying",
#:   "Pushbike ahead pulling clear... engine's blown, he's at a dawdle. Over.",
#:   "We never did anything to catch the racing bike that had shot away from us, except go on as before until its rider's legs turned to porridge.",
#:   "A burst of standing on the pedals had put half a street between her and our bonnet, and her lungs then gave every metre of it back.",
#:   "The lad in front spent all his pennies at once, and from the second telegraph pole he'd got no more in his pocket than would keep a bicycle upright.",
#:   "Cyclist target, ahead: step increase to 8 m/s for a limited time, then decay to 1.5 m/s, simulating exhaustion; motion is maintained, no stop, lane unchanged.",
#:   "Give our lead bicycle a hero's beginning and a pensioner's end: away from us at a gallop, and after a few breaths hardly turning its cranks at all.",
#:   "Beware of falling for the first half of his act, the flying half, because the man on that bike in front has no second half, only puffing and a walking pace.",
#:   "The gap in front of us breathed. It breathed out when the fellow on the folding bike got up on his pedals and went at the hill as if the hill had insulted him, and I went after him. It breathed in when he sat down again, purple, with his knees going round like a tired mill. I was off the gas by then, and on the brake.",
#:   "My nephew had announced that he'd beat the car to the bakery. He was in front, it was a fair race, and for the first hundred yards I'd have put money on him, as we could scarcely see his jersey. At a hundred and one we had it in front of our bumper, swaying. We arrived at the bakery together, him and me, in first gear.",
#:   "Statement from Box 3. Rider visible ahead of the white lorry, low over the bars, cadence about 120, lorry dropping back. Cadence 90, still good. Cadence 30, rider upright, one hand pressed to her ribs, lorry's brake lights on. Lorry in bottom gear behind rider from there to the end of my section. She never got off.",
#:   "If you look at the chain you can see it all. When we'd settled in behind, the chain was a blur, and he was leaving us. Then you could make out links. Then you could have oiled them one by one. He hadn't changed gear and the road hadn't gone up; it's just that nobody of his shape should go off like that on a company bicycle.",
#:   "Ego speed set at 30. At second 4 the bicycle we follow makes 34 and we lose it from the close-range sensor. At second 9 we've got it back. That isn't us. It is going at 6, having burnt its matches, and it keeps going at 6 with a good deal of shoulder movement. The brake request came late by one second.",
#:   "Messieurs, I am old coureur, I know the défaillance. The young before my Peugeot attacks, bravo, he is out of the saddle, he takes thirty metres, forty. And there, the lights go off in him. He isn't stopping, no, he has his pride; but an ant could ride in his wheel. I had to swim with my clutch.",
#:   "In the telling she had only been late for the ferry. She'd flown out ahead of us down the causeway with her coat standing straight behind her, so that Mother said there goes somebody who eats her porridge. The coat began to droop about the first milestone. By the second it hung, and the wheels beneath it turned so lazily that we had our bumper at its hem.",
#:   "Defence counsel called it a trap. The bicycle in front had withdrawn at such a rate that the defendant reasonably took the road to be free and brought his van up to speed. That it'd be there again, directly before him, and moving at a rate that would disgrace a perambulator, for want of nothing but breath, he could not have foreseen.",
#:   "Don't overtake and don't give chase, I told my lad in the passenger seat who was driving in his head. Why's that bike pulling away from us? Because he's twelve and he's seen us. How long does twelve last? Count. One, two, three, four, five. There, see his elbows go wide. Now he's in front of us and he's crawling, and you, my lad, have hit him.",
#:   "We've all seen the reel: guy on a fixie looks round, sees a Tesla behind him, and goes for it. He actually gets away. Comments are like, legend. They didn't watch to the end. At the end the Tesla's sat there on about three percent throttle, with the legend right in front of it, tongue out, weaving no, just grinding, one foot... other foot... one foot.",
#:   "The log of a rescue boat crew on their way to the slip, by minibus. \"Bicycle in front, keen type, drew off from us at speed. Skipper said follow that man. Man ran out of wind at the bandstand. Remainder of seafront covered at the pace of his recovery, which was poor, he declining to dismount or come aside. Launched nine minutes late.\"",
#: ]
#: adversaries = ["bicycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["accelerate", "slow"]
#: position = "ahead"
#: [[parameters]]
#: name = "OPT_ADV_SPRINT"
#: low = 6.0
#: high = 8.0
#: unit = "m/s"
#: meaning = "how fast it sprints"
#: [[parameters]]
#: name = "OPT_ADV_TIME"
#: low = 1.5
#: high = 3.0
#: unit = "s"
#: meaning = "how long it sprints"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 25.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 1.0
#: high = 2.4
#: unit = "m/s"
#: meaning = "how fast it crawls"

param OPT_ADV_SPRINT = Range(6, 8)
param OPT_ADV_TIME = Range(1.5, 3)
param OPT_ADV_DISTANCE = Range(0, 25)
param OPT_SLOW_SPEED = Range(1, 2.4)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego, 4) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPRINT) for globalParameters.OPT_ADV_TIME seconds
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED)
