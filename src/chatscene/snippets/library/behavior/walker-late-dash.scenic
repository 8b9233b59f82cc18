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
#:   "Waved us on by waiting, then shot over regardless.",
#:   "She stood aside for us until it mattered, then bolted.",
#:   "Walked up, waited, waited, and ran when we arrived.",
#:   "I'd taken him for a lamp post, so patiently did he bide at the edge for us to pass, and it was as a hurdler that he left it, inches before our bumper.",
#:   "Bring the jogger up to the kerb and rest him there till the AV regains speed; with the last metres running out, have him go for it flat out.",
#:   "\"After you,\" said her whole posture, with the shopping on the ground; when the cab was practically alongside she'd snatched it up and was pelting to the other side.",
#:   "The kid arrives at the border, he makes stop as in the school, I give gas again, and exactly then he's flying before my lights over the street.",
#:   "How long was the old man standing on the edge as if to let you by? Until I was almost by, your honour, and then he was sprinting.",
#:   "The pedestrian, who had strolled to the verge and halted there in apparent courtesy, left it at a run with 1.3 seconds of the shuttle's approach remaining.",
#:   "In my opinion he'd lost a bet with himself. He had come ambling to the brink; he'd parked his toes on it; I could see him count, as the van came, with his lips. At the moment where any sane man would've said, well, that's that, let it go by, he flung himself out before it and was over in four bounds.",
#:   "The trust is what I resent. There was she, at the edge, feet together, looking at me with those kind eyes, and there was I, in third again, with my hand raised. Had she come at once, I'd have stopped. Had she stayed, I'd have gone. She let me have all the road but the last five yards, and ran across those.",
#:   "Look at the speed of our car here. Dip: that's when the pedestrian turns up at the roadside. Hump: he has stood for a second or two without twitching, so we've concluded he's letting us through. Cliff: emergency brake. What lies between hump and cliff is two metres of tarmac and a man doing twenty-three kilometres an hour over them.",
#:   "The ice-cream van was on my side and the child on the other. Well brought up, I thought. She'd walked, not run, to the kerb; she'd stopped; she was holding on to a railing, even. I was level with the railing, as near as makes no difference, when it was let go of. I've seen swifts go slower past my roof.",
#:   "With us in Naples to stop at the border means nothing, but this was in Zurich, and I believed. The gentleman had stopped, with leather bag and with dignity. He let the tram, he let a bicycle, he would let me. My wheels were nearly there. And the dignity, he throws it away, he gallops, bag on the head, under my nose to the bank.",
#:   "It was all in the heels. I sit low in this thing, so I see people's feet. Hers came up to the kerbstone and were set down flat, both of them, and they stayed flat while I got nearer and thought no more of it. At about a bonnet's length the heels rose. It was a proper start, toes, then gone, and a shoe on my windscreen.",
#:   "Now what did I tell you about people who are standing? They're people who aren't walking yet. He came up nicely, he waited nicely, you said thank you nicely. And you'd taken your foot off the brake. He'd only to hold on one more second for you to be past, and that's the second he chose to go tearing over. Breathe.",
#:   "V1 decelerated on detecting the pedestrian's approach to the curb, and resumed speed when the pedestrian remained there for approximately four seconds, facing V1 and stationary. The pedestrian's son then called from the other side. At that time V1 was 18 feet away. The pedestrian crossed at a full run; V1's bumper contacted her trailing shopping bag.",
#:   "From my forty-tonner I saw him come down the bank, and stop where the grass does. He folded his arms, even. Fair play, son, I thought, there's not many as know what it takes to halt one of these. So I kept her rolling. I had the mirror practically over his cap when it wasn't over his cap: he was off, arms pumping, to the far bank.",
#:   "He waited as herons wait. One had seen him descend to the margin of the road, and become part of it; the taxi came on, reassured, with its small humming sound; it was so near that its lamp had lit his buttons. Then came the lunge. It took him from the one side to the other before the driverless thing had finished saying \"caution\".",
#:   "the waymo slowed for this guy, he comes up to the curb, stops, looks at it, even puts his bag down. waymo goes ok cool n speeds back up. hes WAITING for that. last possible second he full on sprints in front of it. his mate was filming obviously",
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
