#: description = "The crossing car turns right on red into the ego's lane and crawls along."
#: rephrasings = [
#:   "right on red without looking, and then he dawdles along in front of us",
#:   "Vehicle 2 made a right turn on red and proceeded slowly in the lane ahead.",
#:   "right on red, merges, crawls",
#:   "The target turns right against the red signal into the lane of the VUT and continues at low speed.",
#:   "A bus turns to right with red light and after it goes very slow before us.",
#:   "A cyclist slips round to the right on red and pootles on ahead of the ego.",
#:   "The lorry eases right through the red signal, taking its time, and stays slow.",
#:   "Ignoring the lights, a van trundles right into our way at walking pace.",
#:   "he came round to the right on a red and then dawdled along in front of me at nothing miles an hour",
#:   "V2 turned right against the red signal into V1's lane and proceeded at a very low speed.",
#:   "Truck: R on red -> our lane, then snail pace.",
#:   "The crossing target turns right at the red signal into the VUT's lane and continues at minimum speed.",
#:   "The bicycle has red but turns right to my lane and then goes very slow before me.",
#:   "Right-on-red NPC lands in our lane and then becomes a slow-moving plug, ~2 m/s, no stop.",
#:   "The bus slunk round the corner to the right under a red light and then loitered along in front of them.",
#:   "He's come out right on red, straight in front of you, and now look, he's tootling along like it's a Sunday.",
#:   "he turned right on red into our lane and now hes going like 2mph",
#:   "A bus went right against the signal, took the lane, and then idled along at the head of a queue",
#:   "Having turned right on a red signal into my client's lane, you saw fit to dawdle there?",
#:   "Red light he turn right come into our lane, then drive like sightseeing",
#:   "Red's for other people, right he goes into my lane, and then he's pootling like it's a Sunday",
#:   "Right turn on red into own lane with persistent low speed",
#:   "Cyclist turns right on RED then crawls in front of me",
#:   "The lorry slunk right on red and dawdled ahead.",
#:   "Pickup turns right through a red, then ambles along in our lane.",
#:   "Jumps his red to go right, lands ahead, inches onwards.",
#:   "Motorbike goes right against the signal into our lane and potters.",
#:   "Let a bus make a right on red, then trundle before us.",
#:   "Cyclist ignored the red, rounded right into my lane, barely moved along.",
#:   "With the signal firmly against him the taxi driver came round to his right, joined my lane and proceeded to take the air.",
#:   "A truck from the crossing street, red for him, bends right into our lane and from there he is rolling like a tractor.",
#:   "The cross-street vehicle, facing red, is to enter the VUT's lane by means of a right turn and maintain a very low velocity afterwards.",
#:   "You've a green, but that coach has nipped right on his red into your lane, and he's in no hurry now he's there.",
#:   "Who turns right under a red light, straight into the lane I'm in, and then toddles along hunting for a parking space?",
#:   "Going at a walk ahead of us was a saloon that had got there by rounding the corner, rightward, in defiance of its red light.",
#:   "The lady had her light on red, I could see it from where I was. Still she steered out to her right, took up my lane, and after that she drove as one drives behind a coffin, without ever coming to a stop.",
#:   "V2 faced a red indication on the intersecting roadway. V2 executed a right turn without regard to the signal, entered the lane of V1, and then traveled in it at an estimated five miles per hour until V1 had caught up.",
#:   "A lad on a butcher's bicycle paid no heed to the red. He leaned round the corner on his right hand into the lane of those who had green, ourselves, and pedalled up it as idly as if it were his own orchard.",
#:   "For this run the scooter shall misbehave doubly. It doesn't wait for its red to finish but turns to the right, onto the robotaxi's lane; once there it doesn't pick up any speed, it goes along like somebody window-shopping.",
#:   "In my mirror is a queue of twenty and in front is why. The cement mixer came off the side road at the lights, red, mind you, hung a right into our lane, and has been grinding along at jogging speed ever since.",
#:   "Out he comes on red, bears right, and dawdles before us.",
#:   "Bus disregards red, joins our lane rightwards, then oozes along.",
#:   "Right turn under a red lamp; then a snail in front.",
#:   "Let the cross-street moped take a right while its lamp shows red, land in the ego's lane and hum along ahead at jogging pace.",
#:   "The street sweeper had no green, but it swept round to the right all the same, into our lane, and went on sweeping at three miles an hour.",
#:   "With red he went to the right hand, into my line, and after this he was rolling in front like on a Sunday with the grandmother.",
#:   "Which part of a red light says go right, get in my lane and amble up it with your elbow out of the window?",
#:   "Target: signal red, right turn into VUT lane, v = 2 m/s thereafter; does not stop, does not yield lane, does not accelerate.",
#:   "A queue has formed behind a hay wagon, we hear, which had turned right against the lights into the main road and is proceeding at a crawl.",
#:   "Everything went wrong for the robotaxi at the lights by the abattoir. It had green, and was going to use it, when the truck from the side street, with a red over its head, put itself round to the right and into the lane. And having got it, the truck was in no hurry at all.",
#:   "The bell at the level crossing has more go in it than she had. From behind a red light, if you please, she brought her little car round the corner to her right, so that she was in my lane, in front of my lorry. I changed down. I changed down again. We did the length of Mill Street in crawler.",
#:   "I don't mind a turn on red. It's legal where I come from, you stop, you look, you nip out, you push on. What the cab did was the first bit without the rest: red lamp, round to the right, plonk in the lane ahead of me, and then he toured. Walking speed. The entire block. Me on his bumper.",
#:   "That's a red on his side, so he should be waiting, but he's got his front wheel out already. Right he goes, into your lane. What will he do next, pedal? Not he. See how he's only just keeping his balance? He'll be up ahead of you like that for a while. Second gear, and no sighing.",
#:   "Funeral directors, as a rule, keep the law. Ours had the lamp at red and the family behind him. He led off nevertheless, to the right, out of Chapel Street and straight into the lane of the airport shuttle, before which he then progressed, as the dead deserve, slower than a man on foot. The shuttle's clients missed two flights.",
#:   "V2 was facing a steady red indication. V2 turned right and entered the lane in which V1 was approaching on green. V1's forward camera shows V2's speed as 4 to 5 mph from completion of the turn until the video's end, eleven seconds later. V1 braked and was struck from behind by V4.",
#:   "I heard a click-click-click and looked for it. It was the freewheel of a bicycle, of a girl with a cello, who, having a red light to look at, had looked at something else. She'd coasted out of the side road, to the right, into my lane, and she was coasting yet, so leisurely that I could count the clicks.",
#:   "As expected the AV reacted to the red-light violation. What it didn't do well is afterwards. The van had come round right out of the cross street into our lane, that was over in three seconds; but it stayed ahead at 1.8 m/s for the rest of the block, and we kept closing up and braking, closing up and braking.",
#:   "So this coach, from Spain, didn't understand our traffic light, or they understand it otherwise. It was red for them. Slowly out, to the right, on the lane where I am coming. Okay, welcome. But then they were looking for the hotel, all fifty with the nose on the glass, and it went with the speed of nose on the glass.",
#:   "The boy had been told that red meant stop and so he asked. \"It does,\" said his aunt. The delivery van which had just come round the corner to its right, out from under a red light, was ambling along in their lane before them, at about the rate of the ducks. \"And what does he mean?\" \"Ruin,\" said his aunt.",
#:   "dashcam: \"right on red, then NOTHING\". pulls out on his red, takes the right into my lane, i brake, fair enough. then we go like 5mph. for a minute forty. i left the whole thing in the video so you can suffer too",
#:   "Right on his red, into our lane, and tortoising.",
#:   "She took the corner on red, rightward, then idled ahead.",
#:   "Cab defies red, swings right, leads us at a stroll.",
#:   "Our green was worth nothing: a bread van had already come round to its right from under a red lamp and was now setting the pace, a toddler's.",
#:   "For twenty seconds I could read the cyclist's jersey, the man having leaned right out of his side road on a red and into my lane, barely balancing.",
#:   "Have the truck disregard its red, bear right so that it's ahead of the ego in the ego's lane, and never let it get above two metres per second.",
#:   "He has the red, he turns to his right side on my lane all the same, and now we are driving all together like behind a cow.",
#:   "Who's at the head of this tailback? A hearse, sergeant, that made its right turn with the signal at stop and since then hasn't been above walking pace.",
#:   "From the red-lit side road a coach oozed to its right into the lane of the shuttle, and it didn't ooze any the quicker for having arrived there.",
#:   "I waited for him to change up. You do, when someone's nipped out of a side street to the right under your nose, with his light at red; you brake, you call him something, and you wait for second gear. There was no second gear. We went past the baker's in first, past the bank in first, and I could hear my own tyres.",
#:   "The odd thing on the tape is the phases. Our lamp's green, so his is red, and he's moving; he comes about to his right and is ahead of us in the lane. Fine, a violator, we've braked. And from there the tape is of the back of a motorbike for eighty seconds, with feet down, paddling, at the pace of the prams on the pavement.",
#:   "She could walk faster than this, she told the driver, and she did. She got down from the bus, which was stuck behind a dray; she went alongside the dray; she asked the man whether he knew that his light had been red when he turned right in front of them out of Cooper Street. He said he did. He was still rolling as he said it.",
#:   "We passengers had no idea of lights. What we noticed was one good jolt, and that after it the trees went by so slowly that you could study the bark. In front there was a caravan. It had got there from the side, by going right when its signal said not to, as the attendant explained, and then its driver had simply not bothered to accelerate.",
#:   "The defendant was not, he says, in a hurry, and I accept it. A man in a hurry may jump a red light. It takes a special kind to jump it at leisure, swing to the right into a lane full of people whose light was green, and conduct them up the hill at four miles an hour with his indicator going.",
#:   "In my country right on red is allowed, but only if you vanish quickly afterwards. This little car vanished not at all. It was before me, that's how I know its light was red, because mine was green; it had come around the corner to its right hand. And there it was then strolling, ten minutes, up to the school, as if it wanted to be photographed.",
#:   "Don't be clever and try to squeeze by him. He's got no business being there, I know, he had a red; he's come round to the right regardless, straight into your lane. But he's there. And is he picking up? Watch the needle: six, six, five. It's an old lad on a trike with his shopping. So it's six for us as well.",
#:   "V2 was on the intersecting street, facing red. V2's path was a right turn that ended in V1's lane, some forty feet ahead of V1. Thereafter V2's speed, taken from its own recorder, lay between 3 and 6 mph for 350 feet. The operator was reading addresses. V1 came up behind; V3, expecting traffic to flow, came up behind V1.",
#:   "There was a lamp the colour of a plum, and under it, round the corner to the right, came the priest on his moped, as serene as if it had been green. He settled in their lane before them. They had a train to catch. The moped made the sound of a moped and the speed of a procession, and nobody liked to hoot.",
#:   "A late green is what I'd call it, though it was on time. It's merely that the forklift carrier from the side street, on red, had turned right and was in the lane ahead of my artic. Fifty yards on, I had him at walking pace. Two hundred yards on, I'd him at walking pace. My air tanks were hissing from all the dabbing.",
#:   "lol dude in a g wagon rolls right thru his red, takes the right turn, now hes IN my lane, and after all that effort he goes what, 4mph?? taking a phone call. my av just sits behind him like a sad dog. light behind us changed three times",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advMeeting", "advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "turn-right", "slow"]
#: control = "signal"
#: position = "crossing"
#: side = "right"
#: maneuver = "straight"
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
#: meaning = "how fast it turns and goes on"

param OPT_ADV_DISTANCE = Range(-5, 15)
param OPT_SLOW_SPEED = Range(2.5, 3.8)

advTurn = ("straight", "right-turn")

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_SLOW_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED) until abs(offsetFrom(egoRoute, self)) < 6
    do DrivePath(egoRoute, globalParameters.OPT_SLOW_SPEED)
