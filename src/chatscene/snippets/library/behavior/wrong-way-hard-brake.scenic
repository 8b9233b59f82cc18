#: description = "The oncoming car comes the wrong way in the ego's lane, brakes hard, and stops."
#: rephrasings = [
#:   "he's coming at us in our lane and then stamps on it at the last moment",
#:   "Vehicle 2, travelling the wrong way, braked heavily and came to rest in the lane of Vehicle 1.",
#:   "wrong-way, emergency braking, standstill in our lane",
#:   "The target approaches in the lane of the VUT against its direction and brakes fully to standstill.",
#:   "The truck goes in wrong direction, it sees us and brakes strong until it stands.",
#:   "A biker charging up our lane slams everything on and stops dead.",
#:   "The ghost driver realises it and screeches to a halt before the ego.",
#:   "On the wrong side, a van skids to a stop right in our way.",
#:   "he was coming head-on in my lane, and then he stamped on the brakes and pulled up in front of me",
#:   "V2, traveling the wrong way in V1's lane, braked heavily and came to a complete stop.",
#:   "MC wrong way in our lane, emerg. brk, stands.",
#:   "The oncoming target travels in the VUT's lane against the direction of traffic and makes a full braking to standstill.",
#:   "The truck comes on my lane from the front, false way, and then he brakes full and stands.",
#:   "Ghost driver with panic stop: head-on in the ego lane, max decel to v=0, remains nose to nose with the SUT.",
#:   "It had been rushing at them on their own side of the road, when its wheels locked and it stood there, bonnet to bonnet.",
#:   "He's on your side, he's coming straight at you, and he's seen you, slams everything on... stopped.",
#:   "he came at us the wrong way in our lane then slammed the brakes n stopped",
#:   "A ghost driver pulled up with screeching tyres nose to nose with a family car",
#:   "Travelling against the flow, you met my client in her lane and only then braked, violently, to a halt?",
#:   "Wrong side he is coming in our lane, sees us, full brake, standing face to face",
#:   "Some wrong-way wally in my lane, headlights on me, tyres howling, stops dead and we're staring at each other",
#:   "Wrong-way opposing traffic in own lane with hard braking to standstill",
#:   "WRONG WAY biker slams brakes nose to nose with me",
#:   "The lorry charged up our lane from the wrong end and screeched still.",
#:   "Van against the flow in your lane, now stopped, smoking tyres, over.",
#:   "Ghost rider heading at me in my lane, grabs everything, halts.",
#:   "I want a coach on our side, oncoming, that emergency-stops facing us.",
#:   "Contromano in my lane he comes, frena fortissimo, and stays fermo before me.",
#:   "That lorry came the wrong way in our lane and went SCREECH and stopped",
#:   "When I'd got my eyes open again the taxi was stationary, its bumper to mine, having driven towards me in my lane and been braked to within an inch.",
#:   "The opposing target occupies the VUT's lane contrary to the traffic direction, applies maximum deceleration at the trigger distance and remains at rest ahead of the VUT.",
#:   "What saved us was that the tourist heading up our side of the road in his hired SUV woke up and braked with all his might to a dead stop.",
#:   "A bus bound the wrong way along the robotaxi's lane was brought to a shuddering standstill yesterday when its driver, late in the day, noticed the taxi's lamps.",
#:   "If you ever get one driving at you in your own lane like that pickup, ease over, flash him; there, he's locked up his wheels, he's stopped.",
#:   "So it's your evidence that this motorcyclist, travelling in the lane meant for you and against you, braked as hard as he could and came to rest there?",
#:   "I'm not a swearing woman, but I swore. A great big lorry was bearing down on me in the very lane I was driving in, no question about it, it was on my side. At last the driver must have seen me, because there was a hiss and a howl and smoke, and it stood still, towering over me.",
#:   "V2 had entered the divided highway by an exit ramp and was proceeding south in a northbound lane, the same one as V1. Seeing V1, V2's operator made an emergency application of the brakes. The vehicle left fourteen metres of skid marks and stopped, still in V1's lane and still facing it.",
#:   "Here's the one I need for the head-on suite. A car drives at us in the lane we're in, in the opposite direction to what's allowed. It then does a panic brake, everything it has, until it's at a standstill and blocking us. It shouldn't slow gently, and it shouldn't back off afterwards.",
#:   "Everyone on the forum's blaming the sat nav. Anyway, foreign camper comes at me round the bend in MY lane, on MY side, wife screaming. He throws out the anchors so hard that the bikes on the back jump off their rack, and the whole thing grinds to a halt, and we just sit there, headlamp to headlamp.",
#:   "In Germany the radio warns you of such people, but I heard no warning. I drive on the right lane and in exactly this lane comes a motorbike towards me, false direction. The man brakes so strongly that the back wheel lifts itself, and then he stands, directly before my car, and shakes.",
#:   "Truck in your lane, wrong direction, all anchors out, halted facing you.",
#:   "biker coming head on in MY lane locked it up and stopped",
#:   "Contraflow coach on our side: wheels smoking, stationary, headlamps in our eyes.",
#:   "It hadn't any business in that lane, which was ours, or with its nose to us, and only a stamp on the pedal made it stop short of our radiator.",
#:   "An opposing vehicle in the lane of V1 was brought from approximately fifty miles an hour to a dead halt, as its forty-metre skid marks attest.",
#:   "Two cars nose to nose in one lane: hers, which belonged there, and his, which had come up it the wrong way and been braked until the tyres burst.",
#:   "Simulate a falschfahrer on a motorcycle; in the ego's lane he approaches against the traffic, seizes his brakes at the last reasonable moment and remains standing there.",
#:   "How did that camper come to be standing facing us in our lane? By driving up it against the stream, and then by a most almighty application of the brakes.",
#:   "I give the van driver this much, once he'd grasped which way our lane runs he stood on his brake till he was stationary, ten feet from us, staring.",
#:   "The signs at that slip road have been stolen, so it wasn't entirely her fault. I was in my lane, going the right way about it, and there was a Fiesta in my lane going the wrong way about it. She saw me and simply braked with everything there was. The thing squatted, howled and stood. We looked at each other through two windscreens.",
#:   "My dear, I have buried two husbands and I was quite prepared to follow. The autobus was on our side of the road, ours, and it was pointing at us. Then there was the most dreadful grinding noise. All its passengers bowed. And it had stopped, in front of our little bonnet, where it stayed, shaking, with its driver making the sign of the cross.",
#:   "On the recorder the closing speed of the lead object is a hundred and forty, and you'd think the sensor had gone mad, because nothing in your own lane should be closing at that. It was a pickup. It was coming the other way in our lane. From the wild spike on its deceleration, and from the final value of nil, you can tell how the driver woke up.",
#:   "Anyone can end up on the wrong carriageway at night. It's what you do next. This lorry driver was bowling along up our lane, lamps full in our face, and when he'd twigged he didn't dodge and he didn't dawdle. He anchored that thing up so hard that the load shifted, and he sat there with it, stock-still, hazards going.",
#:   "A rear wheel in the air, that was my first sight of it. It came down, and then I could see a rider underneath, and that he'd stopped, and that he'd stopped in our lane with his face towards us. Only then did I put two and two together. The fool had been riding up our side against everybody, and had grabbed a fistful of brake for us.",
#:   "Highway patrol says the taxi went the wrong way for a mile and a half. I can only speak for the last hundred yards. It had the same lane I had, it was heading for me, and it was moving. And then its front end went down like it was looking for a contact lens and it wasn't moving, and its bumper was right there.",
#:   "Head-on matrix, row 3. Position: inside our lane. Orientation: facing us. Initial speed: as traffic. At the trigger the target brakes to the limit of adhesion, with no steering, and from then on is a standing obstacle in our lane, front towards us. Row 4 is the same thing at a gentle rate; don't mix them up.",
#:   "The judge wanted to know where the smoke had come from. \"From his tyres, my lord. He was on my side.\" \"On your side?\" \"In my lane, my lord, coming at me. I dare say he thought it was his.\" \"And he braked?\" \"Like you never saw. That's your smoke. And when it blew away there was his bus, stopped, with the door at my mirror.\"",
#:   "I was cycling behind the robotaxi, in the lane it's supposed to be in, so I was behind a good solid piece of metal, thanks be. In the same lane, from the other direction, there was a hatchback on its way to us. I heard it before I saw it, all four tyres. It ended up at a standstill, and so did my pulse, nearly.",
#:   "There is an instant, said the captain, in which one knows that the other fellow is in one's water. His lights were not to the left of us, where lights ought to be; they were dead ahead in our own lane and growing. Then they plunged, as a ship's do in a head sea, there was a long scream of rubber, and they hung motionless before us.",
#:   "Is not normal here, no, I want to explain. In the island they drive on the other hand. So the tourist on the big motorbike, for him it was correct, he comes to my truck in my lane with good conscience. When he understood, he has pulled everything that one can pull, and stood, white of fear but standing, at two metres from my number.",
#:   "Headlights in OUR lane, wheels locked, halted nose to nose.",
#:   "wrong way dude in my lane, slams anchors, full stop, staring at me",
#:   "HGV against traffic, your lane; smoking tyres; at rest facing you. Over.",
#:   "Between our front number plate and its front number plate, in our own lane, there was by the end a bicycle's length, thanks to forty metres of the coach's rubber.",
#:   "It came up our lane as if the arrows on the road had been painted for it, and when it saw who they'd been painted for it locked everything and was still.",
#:   "What we met in our lane was a pickup's radiator, coming; what we were looking at, after one long howl of its tyres, was the same radiator, steaming, and not coming.",
#:   "The target shall travel in the subject vehicle's lane contrary to the direction of traffic, decelerate at its maximum upon reaching the trigger distance, and remain stationary thereafter.",
#:   "Hard left's no use, he's in our lane and so are we, so brake; thank God he's braking as well, like a madman, look at him shudder, and now he's stopped dead.",
#:   "Put a motorbike into our lane that's going the way nobody's meant to go, let it all but stand on its nose when it spots us, and leave it stopped there.",
#:   "I know which marks are mine, they point north, as the lane does. The other pair points south. They're in the same lane, and they get blacker and blacker towards me, and they finish in two little crescents, where a minibus full of Belgians had come to the end of what its brakes could do. We got out. There was room between the bumpers for the driver and me to shake hands.",
#:   "On the bridge you can't go anywhere, it's got a railing. I said to my wife, that one's on our side. Then his front went down so far that I saw his roof. I saw it for a long time, with smoke behind it, getting bigger; and then it wasn't getting bigger. The springs let it up again, and there were two people in there with their hands over their eyes.",
#:   "The lead distance shrinks at 140, then at 90, then at none, and the lead vehicle shows no rear lights. Naturally: we've got its front. It's in our lane and it faces us. The 140 is ours plus its; the 90's what was left when it had been on its brakes for a second; the none is the two of us at rest, looking at one another's wipers.",
#:   "The lady had come down the exit instead of the entrance, sergeant, so she'd the whole dual carriageway to herself, my half of it. I flashed. She flashed me back! Then she read the back of a sign, I suppose, and did the right thing, the only one left, she pressed that pedal as if to push it through the floor. That's her. She's not moved since.",
#:   "You'll meet it once in thirty years, my instructor said, and it was that afternoon. Over the brow, in our lane and none of theirs, there's a furniture van showing us its face. Off the gas, he says, wait. It sits down on its front wheels with a noise like a slaughterhouse and slides up our lane until it has stopped, and we've stopped, and he says: once.",
#:   "A little applause, please, for ABS. We're doing the test loop clockwise, all of us, lane one. Somebody from catering does it the other way about in the sandwich van. So in lane one there's our prototype, and nose-on to it, doing fifty, there's egg and cress. You hear the thing's brakes going grrrrrr from first to last. Nobody's touched. It's standing at six metres from us with its flap open.",
#:   "In our traffic wrong side is normal, sir, but they come slowly, slowly, on the edge. This bus came in the centre of my lane, from the front, at his full speed, as if I'm the one not existing. At fifty feet he believed in me. All four tyres were crying. When it had become quiet, his bumper was there, my bumper was here, one goat could pass.",
#:   "They ask a lot of a haulier's nerves. You hold your lane because it's yours, and there's a set of headlamps holding it as well, the other way. The gap's going like water down a sink. And the gap stopped. I swear, it had just stopped, ten feet short, with a whiff of burnt linings, since he'd found his pedal: a taxi, planted, in my lane, lights up my nose.",
#:   "Members of the jury, you may think that he who stops does no harm. Consider what he stopped from. He'd driven half a mile of Mrs Lamb's lane, towards Mrs Lamb. It was the sight of her that caused those thirty-one metres of skid, at the end of which his car stood, as it was to stand for an hour, headlong before hers.",
#:   "It was like in the mirror at the fair, when you walk to it and somebody walks to you. In our bit of the road was a motorbike, and it was driving to us. Mum screamed. His back wheel went up in the air like a donkey and there was a stink. Then it came down, boing, and he stood there with his legs out.",
#:   "The fog gave us ten lengths' warning. Two yellow eyes opened in it, not to the side of our path, where eyes belonged, but upon it; and they were travelling. They plunged, as a ship's lamps do. There was a scream of tyres, more theirs than ours; and when it ended the eyes hung a yard off, quite steady, in our lane, and blinked.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "wrong-way", "brake", "stop"]
#: position = "oncoming"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 7.0
#: high = 12.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 15.0
#: high = 45.0
#: unit = "m"
#: meaning = "distance to the ego at which it brakes"

param OPT_ADV_SPEED = Range(7, 12)
param OPT_BRAKE = Range(0.5, 1)
param OPT_ADV_DISTANCE = Range(15, 45)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < 75
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED) until self.pose[3] > 5 and abs(offsetFrom(egoRoute, self)) < 1 and gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(against(egoRoute), globalParameters.OPT_BRAKE)
