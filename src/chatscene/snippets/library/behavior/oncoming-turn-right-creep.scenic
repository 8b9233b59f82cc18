#: description = "The oncoming car turns right into the road the ego is taking and crawls along."
#: rephrasings = [
#:   "the one opposite turns right into our street and then just dawdles there",
#:   "Vehicle 2, oncoming, turned right into the same street as Vehicle 1 and proceeded slowly.",
#:   "opposing right turn into same road, very slow",
#:   "The oncoming target turns right into the destination lane of the VUT at low speed.",
#:   "The bus from the other side turns to right in the street where also we go, and drives slow.",
#:   "A lorry facing us rounds the corner to its right at a crawl.",
#:   "Both want the same road, and the van that comes from ahead takes it first, inching round.",
#:   "Coming the other way, it bears right with no haste at all and stays ahead of the ego.",
#:   "The one facing me turned into the same road I was taking and then dawdled along it.",
#:   "Opposing vehicle made a right turn into the street Unit 1 was entering and continued at a very low speed.",
#:   "Oncoming truck turns R into our exit arm, then crawls ahead.",
#:   "The opposing vehicle turns right into the exit road of the test vehicle and proceeds at walking speed.",
#:   "The bus from the other side turns right in the street where I go, and it drives so slow.",
#:   "Opp. actor's right turn merges into our exit lane at creep speed; we end up stuck behind it.",
#:   "She had meant to go down that lane, but it slipped in from across the way and then ambled along before her.",
#:   "That fellow opposite's going right, into the same street as you, and he's not in any hurry once he's in.",
#:   "the car opposite turned into the same street as me and now its crawling n im stuck behind it",
#:   "A car from the opposite approach turned right into the same street and ambled along it ahead of the other.",
#:   "He took, from the contrary direction, the very street my client was taking, and dawdled there.",
#:   "Opposite side lorry turn right to same road I going, then drive like sightseeing.",
#:   "Coming from over the way, he ducks into my turning first and then has the nerve to dawdle.",
#:   "Occupation of own exit road by slow right-turning opposing vehicle",
#:   "STEALS MY STREET then drives at walking pace",
#:   "The bus opposite bears right into our exit and plods.",
#:   "Opposite lorry rights into our road and then merely ambles.",
#:   "Facing van takes a right into the AV's exit, doing walking speed thereafter.",
#:   "Minibus from opposite goes right, into my street, like a tortoise",
#:   "Let the opposing car turn right ahead of us and then plod along our road.",
#:   "Opposing coach bears right into same arm as unit; proceeding dead slow.",
#:   "A delivery lorry that had been facing us across the junction swung to its right into the very street we were entering, where it dawdled infuriatingly.",
#:   "saloon opposite made its right turn n got into my road before me, after that just its bumper in my face at like zero mph",
#:   "The target approaches from the opposite arm, performs a right turn into the exit lane of the vehicle under test and proceeds therein at 5 km/h.",
#:   "V2, initially oncoming, turned right onto the same roadway as V1 was joining and continued along it scarcely faster than a pedestrian.",
#:   "Bus driver from opposite took his right, same road as mine, and after that he is driving as if somebody walks before him with a flag.",
#:   "Guess who'd picked the same side street: the old chap facing me, who rounded it rightwards at a trickle and then trickled on down the whole length.",
#:   "We were both after Mill Lane, he from the north and I from the south. He had the easier corner, a right-hander, so he was in it before me, and then he tootled along at the pace of somebody choosing a picnic spot.",
#:   "Scene wanted: an SUV comes from the direction opposite to the ego's and makes a right into the road that the ego's route leads into. After completing the turn it does not pick up speed but creeps along there, so that the ego has to trail it.",
#:   "The cement mixer had its right indicator going as it came to meet her, and round it went, ponderously, into the road she wanted. She followed it in, and there they were, the two of them, advancing up the hill by inches.",
#:   "What we learned from the log: the vehicle coming the other way was correctly predicted to turn right into our exit road. What wasn't predicted was its speed afterwards, barely one and a half metres per second, for the whole of the block.",
#:   "I don't mind anybody going first, honestly. But if you come from the opposite side, take the right-hander into the road that I'm taking as well, and then do four miles an hour along it, you've got to expect me to talk to myself.",
#:   "Facing minibus takes its right into our street, then barely rolls.",
#:   "Lorry from opposite: right turn, our exit, slug's pace from there.",
#:   "beat me to the side road from the other direction, now he's sightseeing",
#:   "A skip lorry coming the other way made its right-hander into the lane we wanted and thereupon forgot what the accelerator was for.",
#:   "The opposing target completes a right turn into the exit arm shared with the VUT and continues along that arm at no more than walking speed.",
#:   "From face to face with us he went round to his right, in the same street that was mine, and there he drove how a snail with luggage.",
#:   "Our street was theirs as well: the coach, which had been facing us, swung right into it and set about climbing it at the speed of ivy.",
#:   "Put a van on the far approach, have it turn to its right into the ego's destination road and dawdle along there in the ego's way.",
#:   "V2 approached from the opposite direction, negotiated the right-hand corner into Pine Street, the intended street of V1, and traveled down it at roughly 4 mph.",
#:   "I'd have been home by six. As luck would have it a horsebox, which had been facing me over the crossroads, also fancied Church Lane; it was a right turn for the driver, so in it went, and I spent the whole of Church Lane learning what the horse looked like from the back.",
#:   "What kept us wasn't the junction but what came after. The hatchback from the other approach had curled off to its right into the road on our route, entirely properly, and then its speed simply stayed where it had been on the bend, about that of somebody pushing a barrow.",
#:   "You've both got the same exit, you and that bus opposite. His is the right turn, so he'll be in there first, that's fine; only look, he's in, and he isn't picking up at all, he's tiptoeing down the road. So you'll be tiptoeing too.",
#:   "Trajectory summary for the other agent: initial heading opposed to ours; a quarter circle to its right; final heading equal to our own final heading, same lane. Speed on the last leg is 1.4 m/s with no tendency to increase, which leaves the ego behind it.",
#:   "It's the sort of thing that turns you into your father. The old Rover came towards us with its right-hand winker going, disappeared round the corner into the very road that we were taking, and when we got there it was thirty feet in and apparently counting the lamp posts.",
#:   "We saw its face first and its bottom afterwards, said the little girl. The cement lorry had looked at us from the other side, then it went round its right-hand corner into our road, and then its bottom was in front of us for ages and ages because it only crept.",
#:   "My claim is for the missed ferry. The road to the harbour was on my route and also, it turned out, on that of a removal firm, whose truck arrived from the opposite side, bore right into the harbour road, and from there on proceeded at the pace of the removal men walking.",
#:   "I could hear my pupil breathing through her nose. The pickup that had been facing us was tooling along the side road in front of us at a crawl; we'd let it complete its right turn in there, and that was our reward for being polite.",
#:   "From the mast camera one sees two routes ending in the same lane. The robotaxi's comes from the south; the northern one is that of a delivery truck that bends to its right into the lane and afterwards advances by a metre or so per second.",
#:   "A question for truckers: when you've come from the other side, and you've made your right into a street that a car opposite is plainly taking too, do you have to walk her down it in first gear? He did, all the way to the pub.",
#:   "In our colony main gate there is one road only. From opposite side school bus came, right side he turned, same road which I had to enter, and after entering he is driving as if road is made of eggs, so behind him slowly I also.",
#:   "Faced us, rounded its right-hand corner into our street, and dozed on.",
#:   "Lorry from across: same exit as ours, its right, then 5 km/h.",
#:   "Met him head-on at the corner; now I'm admiring his bumper at walking pace.",
#:   "The bus showed us its face across the junction, then its left flank, then its back, which was in our street and hardly getting any farther away.",
#:   "I lost the race for Pond Lane to an old boy coming the other way, who needed only a right for it, and he then strolled along it.",
#:   "Have the opposing van use the right-hand corner to get into the arm that the ego is bound for, and let it ooze along there in front of the ego.",
#:   "Both of you want that street; for him over there it's the right-hander, so he'll be in it before you, and from the look of it he'll be counting the daisies.",
#:   "V2's route, from the opposing approach, consisted of a right turn onto the link that was also V1's destination link, along which it maintained 1.5 m/s.",
#:   "Vis-à-vis came a camion, he bended on his right in the street which also I take, and after this he advanced like a man who pushes a piano.",
#:   "What we ran out of was patience, not room. The horsebox from over the way had gone round its own right-hand corner in good order and left us space to fall in after it. But it had gone into our road; and there, hooves clattering, it was managing about two miles an hour, with us for company.",
#:   "I'd expected that, once they were round, they'd buck up. It was a removal truck and it had been pointing at us from the other side; its corner was the right-hand one, ours wasn't, but both led to Quarry Hill. Quarry Hill was where it didn't buck up. I could've read its tyres, brand, size and all.",
#:   "We were to be at the church by eleven. My cousin was bringing us from the south. From the north came a hearse, would you believe, for the same church; off to its right it went, into the avenue, with all proper gravity. So that was the pace of the wedding, too, at a hearse's heels, the full avenue.",
#:   "Which of the two should go first was never the question, says the company. The delivery van from the opposite arm had the easier path, a right, and took it. The question is what a robotaxi ought to do in a road that it has chosen and in which someone now goes ahead of it at the speed of a wheelbarrow.",
#:   "If there'd been a gap between his lights and mine I'd say that he came from miles off, but no, we faced each other across the box like two dogs. He had the right to take, I'd the other way about, into one and the same street. He wagged off into it. I followed, on the clutch, at a trot; no, a walk.",
#:   "The camera on the rooftop sees two arrows that start at opposite ends and finish in the same lane. The one from the top, a coach, bends rightwards as its driver sees it. From the bend onward the dots in that arrow, one for each second, are so close together that they touch; they were at five km/h.",
#:   "Indicators, my pupil observed, don't tell you how long it'll take. Quite. That Jaguar opposite had his right one going and he has done what he promised, and the road he promised to go into is ours as well. So now we've his exhaust before us, and the birds are walking past it.",
#:   "Ticket says the ego tailgates after the merge. It doesn't; look who's in front. The agent spawned on the far arm, facing us, made its right turn into the exit that is on the ego's route, and has never since done more than 1.5 m/s. At such a speed any distance looks like tailgating.",
#:   "Nobody's chips stay hot for ever. Mine were on the passenger seat. The skip lorry came towards me over the crossroads with its winker on the driver's right, and it wound itself into my own road ahead of me, chains swinging; and it was so afraid for its chains that we did the last half mile at the rate of my mother.",
#:   "Old Mr Pym saw the carrier's cart of the present age, a brown van, come on from the other side, wheel about to its right hand and enter the lane that led to his own gate. He thought nothing of it. He'd thought of a good deal by the time they reached the gate, for it dawdled before him like a cow.",
#:   "At temple junction both of us wanted the Tank Road. I'm from station side, school van is from opposite side. He took his right hand, he entered, fine, children first. Then I also entered, and what is this, van is going like somebody is painting the road just in front of it, and painter is tired.",
#: ]
#: adversaries = ["car", "truck", "bus"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "turn-right", "slow"]
#: position = "oncoming"
#: maneuver = "left-turn"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -5.0
#: high = 15.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 2.5
#: high = 3.8
#: unit = "m/s"
#: meaning = "how fast it turns"

param OPT_ADV_DISTANCE = Range(-5, 15)
param OPT_SLOW_SPEED = Range(2.5, 3.8)

advTurn = "straight"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_SLOW_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED) until abs(offsetFrom(egoRoute, self)) < 6
    do DrivePath(egoRoute, globalParameters.OPT_SLOW_SPEED)
