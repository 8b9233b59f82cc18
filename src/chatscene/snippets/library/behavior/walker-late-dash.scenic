#: description = "The pedestrian walks to the edge of the road, waits there as if to let the ego pass and then sprints across at the last moment."
#: rephrasings = [
#:   "He's waiting at the kerb like a good boy, and then he goes for it right under our nose.",
#:   "The pedestrian approached the curb, paused, and ran into the path of Vehicle 1 at the last instant.",
#:   "ped waits at edge, then late sprint over",
#:   "The target halts before the lane and starts to run across when the VUT is close.",
#:   "The person waits first at the border, then very late he runs fast over the street.",
#:   "A woman trying to catch her tram lingers at the roadside and makes a mad rush for it.",
#:   "We think she is going to let us by, but off she shoots.",
#:   "A schoolkid stands there biding his time until a last-gasp run to the opposite side.",
#:   "She stood at the kerb looking like she'd let me go, then legged it at the very last second.",
#:   "The pedestrian waited at the curb, appearing to yield, then ran into the path of Unit 1 at the last moment.",
#:   "Ped at kerb, waits, feigns yield, bolts late.",
#:   "The pedestrian target walks to the kerb, remains stationary, and starts a sprint across at minimal TTC.",
#:   "The girl goes to the border and waits, I think she lets me pass, but then she runs very fast over.",
#:   "Fake-yield ped: approach, wait at edge, late sprint across; intention prediction trap.",
#:   "He came to the edge and stood politely, and just as she trusted him he hurled himself across.",
#:   "He's waiting for you at the kerb, isn't he? No! He's gone for it right under your wheels.",
#:   "she was standing there waiting for us to pass and then ran at the LAST second",
#:   "Having seemed content to let the car go by, a man bolted from the kerb as it drew level.",
#:   "She stood at the edge, you took it she would wait, and when you were all but upon her she ran?",
#:   "Uncle was standing at the side to let me go, then last moment he ran across.",
#:   "Waits on the kerb good as gold till I'm nearly on him, and then he goes, the daft beggar.",
#:   "Deceptive waiting of pedestrian at road edge with last-instant running crossing.",
#:   "WAITS AT THE CURB... THEN RUNS AT THE WORST MOMENT",
#:   "A woman dallied at the kerb, then catapulted across at the end.",
#:   "Kid hangs back at the kerb, then bolts over at the death.",
#:   "Waits politely until we're nearly there, then tears across.",
#:   "Let a jogger approach the edge, pause, then sprint over far too late.",
#:   "Ped reaches roadside, stands as if yielding, late full-speed run across.",
#:   "Old man lets us come, then scampers over at the last gasp.",
#:   "She came up to the road, stopped with her bags as though inviting me through, and then galloped over in front of the bonnet.",
#:   "The boy walks until the border and stays there, so I think I can pass, but in the last second he is running over.",
#:   "The pedestrian shall halt at the lane border for the ego to pass; at two seconds' time to collision it shall run across.",
#:   "Don't trust that one at the kerb; he looks as though he's giving way to you, and, see, there he goes, full tilt, late as can be.",
#:   "How was I to know that a man who had walked up and was standing there so patiently would shoot across right before me?",
#:   "bro walked up to the curb stood there like after you sir then yeeted himself across when the car was basically there",
#:   "I saw the lady stroll to the pavement edge and come to a stop, and I took my foot off the brake again. We were only a few lengths off when she evidently thought better of it and pelted to the other side.",
#:   "The pedestrian approached on foot from the east and remained standing at the edge line for several seconds. As V1 was about to pass, he took off at a run across the lane, and V1's automatic braking was too late.",
#:   "False-courtesy run. The mannequin walks up, rests at the edge until the AV has decided that it's being let by, and then flies over the road at five metres a second with hardly any braking distance left to us.",
#:   "A sandwich in one hand, he ambled to the brink of the road and stayed, looking at us with mild interest. He might have stood so forever; but just when our wheels were almost upon him, he fled across like a rabbit.",
#:   "Auntie came to the side of road and stood, so I understood she's giving me way. When my car was reaching her only, that time she started running full speed to other side, God saved both of us.",
#:   "Strolls up, stands like he's yielding, then bolts under our nose.",
#:   "Courteous at the kerb, till it was too late; then she ran.",
#:   "Ped arrives, parks himself at edge, late gallop over.",
#:   "Let the jogger come up to the roadside, wait there so that the AV takes it for granted he'll let it pass, and then fly over.",
#:   "First it walks to the kerb and is standing patient, the girl; when I'm nearly passing, she starts like a rabbit to the other side.",
#:   "Who comes to the edge, waits there like a good citizen, and then hurls himself over when the bonnet's practically upon him?",
#:   "The man had been at the edge for some time, as if letting my bus through, before he made a mad rush for it right in front.",
#:   "Pedestrian approaches the carriageway, rests outside it with zero speed until TTC equals 1.6 s, then traverses it at a sprint.",
#:   "I'd have lifted for a child who runs, but not for this one, who had come to the brink and waited, until I was there.",
#:   "He'd even nodded, the man with the newspapers. He'd walked down his path as far as the kerb, seen us coming, and planted himself, and gave us that nod which means after you. Our front wheels were about to pass his shoes. That was when he took off, all elbows, for the other side, papers flying behind him.",
#:   "What my pupil learnt today is that waiting isn't a promise. A lady came out of the butcher's, up to the edge, and stood. I said, \"She's letting you by.\" I was wrong! We'd all but got to her, and she broke into a run, a real one, bag and all, and I'd to use my pedals and my vocabulary.",
#:   "On the tape the walker's intention score falls, from 0.8 as she nears the roadside to 0.1 after she's stood there a second and a half. It's at 0.1 when the shuttle is nine metres off. In the next frame she's in the air, both feet, and in the frame after in our lane, doing about six metres a second.",
#:   "To think that I thanked him. I'd raised my hand from the wheel, you know, as one does, seeing that the young man had stopped on the edge to give an old woman her way. My hand was still up when he shot from there like a greyhound. I have not raised it to anyone since.",
#:   "V1's operator observed the juvenile walk to the curb line and stop. The juvenile appeared to be waiting for V1 to go by. V1 resumed 25 mph. At a distance later computed as 22 feet, the juvenile ran across V1's lane at full speed. Asked why, he replied that he'd wanted to see \"if it was really a robot\".",
#:   "She was standing so still at the border of the road, with her hands folded, that I thought of the Madonna. She'd come there walking, seen my truck, stayed, all correct. And the Madonna, when I've only ten metres more, lifts her skirt and runs across me like the devil is behind. My heart, doctor, is since then not the same.",
#:   "It's a bet, that's all it is. Lads in our street do it. You walk up to the kerb, nice as pie, and stand there so the driver thinks you're waiting for him. And you don't go. And you don't go. And then when he's all but level you leg it, fast as ever you can, to the other side.",
#:   "By the time the cyclist in front of the house had shouted, it was over. He'd been watching a gentleman with a briefcase who had come down to the edge of the road and was biding there for the robotaxi to get by. \"He'd all the time in the world,\" he said. \"He used it up, and then he ran.\"",
#:   "Mind games, part three. Place the walker on the pavement; bring it to the edge at a normal walk; and let it stand. We've seen the AV slow at that and pick up again. Just as it has fully picked up, with the least distance that physics allows, off goes the walker, straight over, as fast as the rig will go.",
#:   "It was raining, and the woman had an umbrella, and there was a puddle along the kerb to which she'd walked down. He saw her pause at it; he saw the umbrella dip, graciously, as though to say that the road was his. He remembered the umbrella longest, for it stayed behind, rolling, when she sprang away beneath his headlamps.",
#:   "saw this from the chip shop: guy comes up to the kerb, stops, proper waitin, looks like hes lettin the van past. van comes. van's basically HERE. guy goes usain bolt. van driver got out n just sat on the kerb for a bit",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["hesitate", "cross", "fast"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.2
#: high = 2.2
#: unit = "m/s"
#: meaning = "how fast it walks to the edge"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 2.2
#: high = 2.8
#: unit = "m"
#: meaning = "how far from the ego's line it waits"
#: [[parameters]]
#: name = "OPT_REACT_DISTANCE"
#: low = 6.0
#: high = 15.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it sprints off"
#: [[parameters]]
#: name = "OPT_ADV_SPRINT"
#: low = 4.0
#: high = 7.0
#: unit = "m/s"
#: meaning = "how fast it sprints"

param OPT_ADV_SPEED = Range(1.2, 2.2)
param OPT_ADV_REACH = Range(2.2, 2.8)
param OPT_REACT_DISTANCE = Range(6, 15)
param OPT_ADV_SPRINT = Range(4, 7)

behavior AdvBehavior():
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 4
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for 0.6 seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_ADV_REACH) or headway(egoRoute, ego, self) < globalParameters.OPT_REACT_DISTANCE + 8
    do Halt() until self.pose[3] < 0.1
    do Halt() for 0.5 seconds
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_REACT_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPRINT)
