#: description = "The pedestrian wanders slowly into the lane, turns round and wanders back just as slowly."
#: rephrasings = [
#:   "Somebody confused toddles out, forgets why, and toddles home again.",
#:   "The pedestrian walked slowly into the roadway, reversed course, and walked slowly back.",
#:   "ped slow out, slow back",
#:   "The target enters and leaves the VUT's lane on the same side at 1 m/s.",
#:   "The old man goes slowly on the road and goes slowly back, he is lost.",
#:   "A daydreamer ambles off the pavement, has an afterthought and ambles back.",
#:   "She pads out to look for something and unhurriedly returns.",
#:   "An elderly walker changes her mind midway yet withdraws without any haste.",
#:   "Some dreamer drifted out into my lane, turned on his heel and drifted off again, no rush at all.",
#:   "The pedestrian walked slowly into the lane, turned around and returned to the same side at an unhurried pace.",
#:   "Ped strolls in, about-face, strolls back. Slow both ways.",
#:   "The pedestrian target enters the lane at low speed, turns by 180 degrees and returns at the same low speed.",
#:   "The man goes slow in my lane, turns and goes slow back.",
#:   "Symmetric return: dawdles in, about-turn, dawdles out to the same kerb; no running.",
#:   "She drifted out as if in a dream, thought of something, and drifted back to the pavement none the quicker.",
#:   "He's meandering out, can't make up his mind, and now he's ambling back again; all day, some people.",
#:   "guy slowly walked out, slowly turned round, slowly walked back. ok then",
#:   "A man sauntered into the road, reversed course and sauntered off it, seemingly without a care.",
#:   "Neither in going out nor in coming back did he hasten; he simply turned and returned to his side?",
#:   "He walked slowly into my lane, then turned back also slowly, relaxing only.",
#:   "Out he moseys, forgets what he came for, and moseys home, no hurry either way.",
#:   "Unhurried pedestrian lane entry and equally unhurried retreat.",
#:   "MAN WANDERS INTO ROAD, CHANGES MIND, WANDERS BACK",
#:   "A woman meandered in and meandered home.",
#:   "Ambles into our lane, wheels about, ambles off again.",
#:   "Old man dawdles out, about-faces, dawdles back to his kerb.",
#:   "Ped: leisurely entry, reversal, equally leisurely exit, same side.",
#:   "Let somebody stroll out, turn and stroll back, no hurry.",
#:   "DEMENTIA? Lady creeps into road, turns round, creeps home",
#:   "A woman with her nose in her phone drifted off the pavement into my lane, swung round and drifted back to where she'd started, never quickening.",
#:   "The pedestrian target moves into the VUT's lane at low walking speed, reverses its direction there and leaves by the same side, its speed unchanged.",
#:   "The man walked into the lane as if he was in his garden, then he made a half-turn and went again to his side with the same calm.",
#:   "took him ages to get into the lane and just as long to get out cos he turned on his heel there and ploded back",
#:   "Grandpa went on the road very slowly because he thought he saw the bus, and when it wasn't the bus he turned and came very slowly back.",
#:   "Why the hurry with the horn, when the poor soul was already facing about and shuffling back to the kerb she had shuffled out from?",
#:   "I had plenty of time to look at him, that's how slow he was. He trailed out in his slippers until he was in front of me, stood round to face the way he had come, and trailed back to the pavement without once lifting his head.",
#:   "The pedestrian entered the lane of Vehicle 1 at a pace put at less than one metre per second. Within the lane he turned around and walked to the side from which he had come, no faster than before, although Vehicle 1 was by then braking audibly.",
#:   "What makes this one different is that nobody is startled. Our walker saunters into the lane of the AV, does a calm about-turn, and saunters out of it the way she came, at the very same low speed, so the lane is occupied for quite a while.",
#:   "Never mind sighing at him. An old boy like that has gone out at a snail's pace, he's remembered his glasses or whatever, he's turning round, and he'll go home at a snail's pace too. You just sit here and give him his time.",
#:   "She had come down from the kerb like somebody walking in her sleep, and in the middle of our lane she stood about, turned, and with the same sleepwalker's tread went up on the kerb again. I doubt that she ever knew there was a car.",
#:   "Drifts off the kerb, rotates in our lane, drifts home.",
#:   "Lady dawdles out, has a rethink, dawdles to her own kerb.",
#:   "Slow in, half turn, slow out, same side, pensioner's pace throughout.",
#:   "A man reading his paper trickled off the pavement into my lane, revolved like a weathercock and trickled back where he belonged.",
#:   "Pedestrian advances at reduced walking speed to the ego lane, inverts its heading, and retires to its initial side at an equally reduced speed.",
#:   "What's the use of hooting at someone who takes an age to get into your lane, turns about, and takes an age to get out?",
#:   "Aunty came to my lane like a snail, remembered some vegetable it seems, turned round and like a snail only went back.",
#:   "Have a tourist moon out into the ego's lane, swivel on the spot, and moon off it again in the direction he came from.",
#:   "Traffic was delayed by a sleepwalker who padded into the lane, went about and, no more briskly, padded back to the house he had come from.",
#:   "I switched the engine off in the end. It was that long before he'd got his slippers as far as my lane, and then he had to get himself facing the other way, and then there was the whole business of going home again. Not once did he put on any speed, horn or no horn.",
#:   "There was no alarm in any of it, which is why we thought that she hadn't noticed us. A grey coat floated from the right-hand pavement to the middle of our lane. The next time I looked I saw its front rather than its side, then its other side, and it was floating to the right-hand pavement, quite as slowly.",
#:   "The pedestrian's lateral position, plotted over time, gives a flat-topped hill. The flank going up is shallow, about 0.7 m/s from the kerb into the lane of V1; there's a short summit, where he turns through half a circle; and the flank going down to the same kerb is just as shallow.",
#:   "It'll teach you patience if nothing else will. There's a lad with headphones, he's oozed off the pavement into our lane, and you're waiting for him to ooze over to the far side. He won't, for he's gone right about, look. Now he'll ooze back, and we'll be here for the duration.",
#:   "Somebody in the bus called out that she'd forgotten her teeth. Whatever it was, the old dear, who'd been creeping out in front of us for the best part of a stop, thought of it in mid-lane. She put herself about by small degrees, like a ship, and crept to the kerb that she'd crept from.",
#:   "I'm a slow walker myself so I don't complain. I went out in the lane with my frame, tick, tick, and I saw it was the wrong bus. So I turned the frame, and tick, tick, I went back to my bench. The car with nobody in it waited very politely the whole time.",
#:   "Actor spec: wanderer. It enters the AV's lane at no more than 0.8 m/s, shows no reaction to the AV, makes an about-turn inside the lane and leaves on the side by which it came in. The return leg must not be faster than the outward leg, otherwise it reads as fright.",
#:   "The clock over the chemist's said four minutes past when the man left the kerb, and hardly less than five past when he regained it, the selfsame kerb. In between he'd got only as far as the lane of the van. He had gone there in a reverie, faced about in a reverie, and come away in one.",
#:   "He has neither haste when he comes nor haste when he goes, this Herr with the bathrobe. I stand already. He comes with tiny steps into my lane, there he shakes the head and makes a turn; and with the same tiny steps he brings himself again to his garden door.",
#:   "Never saw him hurry, dash-cam never saw him hurry either. It shows a bloke with a fag wander in from the left at about the speed of a cow, peer up the road, and come about. He wanders off to the left at the speed of the same cow. Total time in my lane, fourteen seconds.",
#:   "We played a game in the car, guess where the lady goes. I said the other side, because she was coming out in front of us ever so slowly. My sister said home. My sister won, since the lady turned herself round in our lane and went home, ever so slowly too.",
#:   "Shuffled out, came about, shuffled home. No panic whatsoever.",
#:   "ped, snail's pace: kerb, our lane, same kerb. fourteen seconds",
#:   "Slowly on stage, slow pirouette, slowly off, same wing.",
#:   "She came into our lane like treacle off a spoon, and having shown us her other profile she went out of it like treacle too.",
#:   "For half a minute he was in the way: dreaming outwards, swivelling round, dreaming home to the side that he'd dreamed from.",
#:   "The walking frame went tap, tap as far as my headlight, got itself pointed at where it came from, and went tap, tap to there.",
#:   "Neither my horn nor the bus's could put any haste into the fellow, not on his way in, not round the bend, not on the way out.",
#:   "Ego-lane entry by pedestrian at 0.7 m/s, heading change of 180 degrees in lane, and exit by the side of entry, likewise at 0.7 m/s.",
#:   "I want a monk deep in thought: he drifts into the AV's lane, comes about, and drifts away to his own kerb at the same pace.",
#:   "You know the little people that come out of those weather houses? One came out in front of us, in a green coat, as if on a wire. It glided to the middle of our lane. Some mechanism turned it about, and as if on the same wire, and in no more hurry, it glided in again where it had come out.",
#:   "There was time for me to unwrap a toffee. He was coming over, I supposed, from the park, in carpet slippers, at the rate of a Sunday; and having got into our lane he'd evidently remembered it was Sunday. I had finished with the wrapper by the time I saw his back. The toffee lasted till he'd regained the park.",
#:   "From the plot you couldn't tell which way the film was running. Outward, the woman moves half a metre a second, from kerb to lane centre. Homeward, she moves half a metre a second, from lane centre to the same kerb. Only the turn in between shows her face. No reaction to the approaching vehicle was observed in either half.",
#:   "Sergeant, I'd estimate he'd had nine pints, and they hadn't made him quick. He came off the step of the Swan like a man wading. He waded to about my wing mirror. He thought about something, he came round, holding on to the air, and he waded to the step again, with all of us sitting there, engines running.",
#:   "Most of them, when they see a bus, will scuttle. She won't, that's why I say be patient. She's inched her way into your lane, and she's had a look at where she was going, and she doesn't fancy it. See? Round she goes, by the clock. Now it's the whole inching in reverse, and you may pull your handbrake up.",
#:   "It was the leaves I noticed. His feet ploughed a furrow through them, from the pavement by the school into the lane in front of our taxi, no deeper at one end than at the other, so that he can't have hurried. At the end of it was a little trampled circle. A second furrow, just like it, led back to the pavement.",
#:   "My mobile home has good brakes, fortunately. The gentleman was mushroom picking, he told after. Very slow he has strolled from the wood into my lane, the basket on the arm, the eyes on the ground. There grow no mushrooms, he has seen. So he turned himself about and strolled, very slow, in his wood, and me he has not seen.",
#:   "Why was the queue forty cars long? Because its first car couldn't get by Mrs. Hale. She'd set out from her gate without looking, at Mrs. Hale's gait, and been in the lane when it came to her that she had left the iron on. She didn't run for the iron. She veered round, and went home at Mrs. Hale's gait.",
#:   "Distinguish this from fright. A frightened pedestrian leaves the lane at several times the speed at which he came. Ours has nothing to fear: he comes from the right at an amble, swings his body through one hundred and eighty degrees in front of the ego, and leaves to the right at an amble. Peak speed, both legs, 0.8.",
#:   "And there I was, trike, full load of nappies, stuck behind a car that'd stopped for a chap on the phone. He's drifting out, yak yak yak, in its lane. He drifts into a sort of bend. Yak yak. He's drifting where he came from, to the bench, same yak, same drift. Sat down. Never knew we existed.",
#:   "The lamplight had her for as long as it takes to say a psalm. It had her left cheek while she paced, with tiny steps, from the wall to the crown of their lane; it had her full in the face as she wheeled; it had her right cheek while she paced, with steps as tiny, to the wall. Then the dark had her.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "slow", "turn-back"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 0.8
#: high = 1.3
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 8.0
#: high = 34.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 0.0
#: high = 1.0
#: unit = "m"
#: meaning = "how far from the ego's line it turns back"

param OPT_ADV_SPEED = Range(0.8, 1.3)
param OPT_ADV_DISTANCE = Range(8, 34)
param OPT_ADV_REACH = Range(0, 1)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 3.5
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 3.14159)
