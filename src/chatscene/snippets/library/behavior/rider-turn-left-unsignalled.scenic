#: description = "The rider ahead suddenly brakes and turns off to the left across the road without a hand signal."
#: rephrasings = [
#:   "The cyclist in front hangs a left with no warning whatsoever.",
#:   "The bicyclist made a sudden left turn across the path of Vehicle 1 without signaling.",
#:   "bike ahead turns left, no signal",
#:   "The target ahead turns left across the VUT's path without any prior indication.",
#:   "The cyclist before us goes at once left without showing the hand.",
#:   "A courier up ahead flicks left for a doorway without so much as a shoulder check.",
#:   "The scooter we follow peels off to the left unannounced.",
#:   "Not looking behind, the biker heads left for a driveway right when we want to pass.",
#:   "The cyclist in front grabbed his brakes and hooked off left over the road, no arm out, nothing.",
#:   "The lead bicyclist slowed abruptly and turned left across the roadway, failing to signal.",
#:   "Bike ahead brakes sharp, hooks L, no signal.",
#:   "The leading two-wheeler target brakes and turns left across the carriageway without indicating.",
#:   "The bicycle before me brakes suddenly and goes left over the street, he does not show the hand.",
#:   "Rider ahead turns left with no indication: short brake, then leaves our lane to the left.",
#:   "She never put her arm out; she just checked, and cut away left across the road ahead of him.",
#:   "Mind that moped in front, no signal and he's jammed on and peeled off to the left!",
#:   "biker in front braked and went left outta nowhere, no hand signal or anything",
#:   "The moped rider checked his speed and swept left over the road without indicating, the inquest heard.",
#:   "You gave no sign by arm or lamp, you braked, and you crossed to the left before her?",
#:   "Front bike suddenly brake and turn left, never put hand also.",
#:   "Does he stick an arm out? Does he heck. Brakes on, over to the left he goes.",
#:   "Unannounced left turn with sudden braking by leading two-wheeler.",
#:   "BIKER BRAKES AND TURNS LEFT - NO SIGNAL",
#:   "The cyclist ahead checked, then veered off left unheralded.",
#:   "Cyclist ahead pulls up sharp and bears left, no arm given.",
#:   "Leading scooter: hard brake, left across road, indicator never used.",
#:   "Biker in front slows abruptly, then sneaks off left without a sign.",
#:   "NO SIGNAL, NO LOOK: bike ahead brakes, swings left",
#:   "Guy ahead brakes, then leftward over our road, hands never leaving the bars.",
#:   "The lad in front of me on a mountain bike squeezed his brakes and shot off to the left over the road, no arm out.",
#:   "Let the moped in front of the AV brake out of the blue and veer away to the left over the carriageway, without any indication beforehand.",
#:   "Had she put her left hand out before slowing and wheeling over to that side in front of you? No, sir, she had given nothing at all.",
#:   "The leading bicyclist target keeps to the right, decelerates abruptly and departs to the left across the lane, the test deliberately omitting any hand signal.",
#:   "The cycle man before our car has stopped pedalling and pressed brake, then he cut to left side of the road, hand he did not show.",
#:   "Our motorcyclist, riding ahead, checked hard and took himself off to the left side of the road; that he meant to do so he told nobody.",
#:   "I was about to go by an old gentleman on his bicycle, who was keeping well in to the right. Without looking or lifting an arm he braked and came round to the left, right over my lane, and disappeared into an allotment path on the other side.",
#:   "V2, a moped travelling ahead of V1 near the right edge of the lane, was braked suddenly. Its rider then steered left and crossed the roadway at nearly a right angle. Neither direction indicator nor hand signal was in use, as the footage of V1 confirms.",
#:   "You can't trust that they'll tell you. This girl ahead on the bike, watch her shoulders, she's stopped pedalling, she's braking, and off over the road she goes, leftward. She ought to have stuck her arm out for that, but she didn't, so you must read it.",
#:   "Riders, please, I'm one of you, but signal! Chap in front of me today hit his brakes for no visible reason and then peeled away left in front of my wheel and of the car behind me, clean over the road, with both hands on the grips.",
#:   "It is the missing warning that makes this case hard. The motorcycle leads, hugging the right of the lane so that you feel invited past it; it brakes, quite suddenly; and in the next instant it lies over to the left and leaves across the road with dark indicators.",
#:   "Moped in front jams up, slips away left, not a blink given.",
#:   "Leading cyclist checked abruptly and cut leftward over us, arms unmoved.",
#:   "No arm, no lamp: biker ahead anchors and vanishes left.",
#:   "The old girl on the bicycle ahead gave her brakes a sudden squeeze and sailed off to the left over our path, hands on the bars.",
#:   "Lead two-wheeler near the right lane edge, sharp deceleration, ninety-degree departure to the left across the ego's course, turn signal inactive throughout.",
#:   "Was I supposed to guess from the back of his helmet that he'd brake all of a sudden and go off left in front of me?",
#:   "The scooter fellow was going before me at right edge, brake he put suddenly and to left he crossed the road, no indicator, no hand.",
#:   "Make the e-bike in front hug the right, brake with no warning, and then head off left over the carriageway with nothing signalled beforehand.",
#:   "Insured was about to pass the bicycle ahead when its rider slowed hard and, without extending an arm, steered over to the left-hand side.",
#:   "I'd moved up nicely to go by her, as she was keeping right in by the gutter. You'd expect an arm, wouldn't you, or at least a look? All I got was a squeak of brake blocks, and there was her basket, broadside, crossing in front of me for the cottages on the left.",
#:   "Where the rider meant to go became clear only once he'd gone. V2, a motorcycle preceding V1 by some eighteen metres, lost half its speed within a second. With its left indicator unlit and both of the rider's hands at the grips, it then swung to the left and crossed the roadway to a field entrance.",
#:   "Hard on the brake, now! That's why I never trust a quiet back. The boy on the BMX has shut his speed right off and he's going over to the left in front of us, never stuck out so much as a finger, and here we were thinking he'd left us all that room on purpose.",
#:   "For those of you listening on the bus: the camera shows a courier ahead, tight to the parked cars on the right. His rear wheel skips. The next frame has him side-on, and he's halfway to the houses on the left. I went through it ten times and neither arm ever comes off the handlebar.",
#:   "An indicator costs nothing, as I said to the sergeant. The motorcycle was ahead of the coach and well over on the right. Its brake light came on as if by mistake, and before I'd decided whether it was a mistake it had tipped over to the left and was going across our bows into the quarry road.",
#:   "The intention classifier put \"continue straight\" at ninety-eight per cent, and I don't blame it. The rider ahead was close to the right edge and gave neither hand sign nor shoulder check. He just decelerated rather brutally and veered away over the road to the left, straight through where we'd have been.",
#:   "My cousin rode in front on her new bike and we came behind in the car. She saw the ice-cream man on the left. So she braked, squeeeak, and off across the street she went to him, and she forgot all about her hand, and Mama forgot all about being polite.",
#:   "In the Vosges the cyclists are kings. This one pedals before me at the right border, very correct. Brusquely he brakes and he throws himself to the left, across all the road, to take the small path, and his arm he kept for himself. My bumper has stopped at one metre of his pedal.",
#:   "There was a flash of chrome on the wrong side of the windscreen. The flash had been, till then, a peaceable red tail lamp on the right, some way ahead of the lorry; it had pulled up short and, without a sign to anyone, hauled itself round and away to the left over the whole road.",
#:   "We request an uncommunicative rider. He precedes the vehicle under test on the right-hand side of the lane as though inviting it to pass. On trigger he brakes sharply to turning speed and leaves to the left across the roadway. The model's arm gesture and the blinker are to remain disabled.",
#:   "Not one motion of the hand, dear, and in my day you failed your cycling badge for that. He was in front of us, he slowed down so suddenly that his mudguards rattled, and then he went off left, right over the road, as though we'd been a puff of air.",
#:   "Biker in front: sharp brake, then left, arms never moving.",
#:   "bike ahead went left over the road, zero signal, zero glance",
#:   "Lead moped sheds speed, cuts left across; blinker stayed dark.",
#:   "Both hands were on the bars when the courier ahead checked, both were on the bars as he swept leftward over the road, and I nearly met him.",
#:   "His brake light told us slower; nothing told us left, and yet leftward over the carriageway is where the motorbike ahead then went.",
#:   "Cyclist ahead, hugging the right, sheds speed hard and departs to the left over the road, no arm gesture having been given; ego overtaking.",
#:   "The bike before me he brakes like he forgot something, and without to show any sign he crosses left in front of my nose.",
#:   "Please leave out the arm signal: the rider in front should simply squeeze the brake all at once and peel away leftward over the road.",
#:   "He was off to the allotments on the left, we know that now; he braked and went, with never a finger off the handlebar.",
#:   "I had picked my moment. He was well over on the right, that moped, pottering, and I'd the whole of the road to go by on. What I hadn't got was a wink from that little orange lamp on his left. So when his red one came on and his tyre chirped I thought only, puncture. He was already broadside, going left.",
#:   "The instructor's notes on this are short: \"Shoulder didn't turn, hand didn't lift, lamp didn't blink, bike did.\" The pupil was about to pass a cyclist who was keeping to the right ahead. She'd lost pace as though she had hit sand, and then went off at right angles, over the whole width, to the gate on the left.",
#:   "If I'd had one sign out of him, one, I would've stayed where I was. He'd been in front since the quarry, tight in to the right, and you'd say he was waving me by. Then, no warning, he's half as quick and twice as near. And where's he going? Left, over both halves of the road, with his elbows tucked in.",
#:   "The red smear of his stop lamp slid from the right-hand edge of my windscreen to the left-hand edge, by way of the middle. It was wet and it was night and that was how it looked. Nothing amber had been seen. I'd just time to feel the nose go down before he and his motorbike were in among the garages.",
#:   "Statement by the rider of V2. She'd been riding along the right side of the lane, aware of V1 to her rear. Seeing her friend's house, she applied both brakes and turned left over the road. She did not extend her arm, \"because I had the eggs\". The driver of V1 had commenced passing and stopped half a metre short.",
#:   "In Poona, no hand means nothing, so I was not expecting any hand. But at least some slowing down in a nice way one can give. This scooter gentleman, ahead of me on right side, gave brake so that his milk can jumped, and at once the fellow was passing left in front of my bonnet to the temple side.",
#:   "For the cyclists among you, here's what it looks like from behind. You're a hi-vis back at the edge of the lane on the right. You stop pedalling; your back gets bigger, quick. Your arms don't do anything. And then it's not a back, it's a side, and it's travelling to the left across my lights. I'm a good driver and I nearly had you.",
#:   "The prediction horizon contained two futures for the motorbike we followed: straight on, or passed by us. There was no third since the blinker bit was zero. It braked at five metres a second squared; it yawed to the left by ninety degrees; it crossed the remaining lane and was gone. The planner's lateral offset was already half a metre out.",
#:   "What use was the horn then? The boy had done it. He'd been a pleasant sort of dot in front on the right-hand side all the way from the school, and without putting out his hand he'd pulled at the levers until the back wheel skipped, and wheeled off over to the left as though the road were his father's yard.",
#:   "\"He'll turn right,\" said my wife, \"he's over on the right.\" I said he wasn't turning anywhere, he'd have put his arm out. We were both of us mistaken. The rider dropped his speed so that I'd to drop mine, and with the reins in both hands, as it were, went over to the left, past our bumper and up a drive.",
#:   "Give it up, the footage won't help you. I've been through it for an indicator, a nod, a hand. There's a helmet, ahead of us and to the right, facing dead forwards. There's a flare of brake light at frame 50. At 62 you've got the helmet in profile, looking left; by 90 it has gone over the road and out that side.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["brake", "swerve", "turn-left"]
#: position = "ahead"
#: place = "road"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.6
#: high = 2.4
#: unit = "m/s"
#: meaning = "how fast it turns"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -20.0
#: high = 5.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts at the latest"
#: [[parameters]]
#: name = "OPT_REACT_DISTANCE"
#: low = 4.0
#: high = 18.0
#: unit = "m"
#: meaning = "how far behind it the ego is when it acts"
#: [[parameters]]
#: name = "OPT_TURN_RADIUS"
#: low = 2.5
#: high = 4.0
#: unit = "m"
#: meaning = "the radius of its turn"

param OPT_ADV_SPEED = Range(1.6, 2.4)
param OPT_ADV_DISTANCE = Range(-20, 5)
param OPT_REACT_DISTANCE = Range(4, 18)
param OPT_TURN_RADIUS = Range(2.5, 4)

behavior AdvBehavior():
    # It keeps right, as if to let the ego pass.
    do DrivePath(advTrajectory, 5, -1.9) until self.pose[3] > 4.2 and (headway(egoRoute, ego, self) < globalParameters.OPT_REACT_DISTANCE or distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE)
    do BrakeOnPath(advTrajectory, 0.5, -1.9) until self.pose[3] < globalParameters.OPT_ADV_SPEED
    do TurnOff(1.5, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_TURN_RADIUS)
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
