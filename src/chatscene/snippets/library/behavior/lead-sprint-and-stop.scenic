#: description = "The car ahead accelerates away and shortly after brakes to a dead stop."
#: rephrasings = [
#:   "The bloke in front floors it, we follow, and then he stops dead.",
#:   "Vehicle 2 sped up, then decelerated violently and came to rest in the lane.",
#:   "Lead surges off, full brake, stationary.",
#:   "The target accelerates ahead of the VUT, then brakes at the limit down to zero and stays.",
#:   "First he gives gas, after that full brake and he stands before us.",
#:   "The lorry before us puts on a spurt only to pull up sharply.",
#:   "A motorcyclist ahead rockets forward and then stands the bike on its nose.",
#:   "The driver we follow opens a gap at full throttle and closes it with a panic stop.",
#:   "The lad in front booted it away from me and then, a few seconds on, stood it on its nose and stopped.",
#:   "The lead vehicle sped up, opened a gap, then shortly thereafter came to a complete stop in the lane.",
#:   "Lead bolts, gap opens, then full brake to 0 & stays.",
#:   "The lead target accelerates away from the VUT and after a short interval brakes to standstill.",
#:   "The motorbike before me goes fast away and soon after he brakes until stop.",
#:   "Lead fakes us out: sprint first, then a full stop just down the road, lane blocked.",
#:   "He raced off from her as if glad to be rid of her, and not a hundred yards on he pulled up dead.",
#:   "He's charged off up the road, but don't chase him, he's stopped, bang, right there in the lane.",
#:   "he zoomed off ahead of me n then boom full stop a few secs later",
#:   "The driver surged away from the car following him only to pull up sharp a short way on.",
#:   "You raced ahead of her, thus inviting her to follow, and moments later you halted outright?",
#:   "First he raised speed and went far, then suddenly he is standing in the road with full brake.",
#:   "Off like Stirling Moss in front of me, and fifty yards on he's stood still in the road.",
#:   "Lead vehicle surge followed by unexpected full stop and blockage.",
#:   "RACES AHEAD... THEN SLAMS TO A STOP",
#:   "The lead car spurted off, then crashed its speed to nothing.",
#:   "Front car shot off, then stopped dead in its tracks shortly after.",
#:   "Simulate a leader that bolts forward, then brakes to nothing and stays.",
#:   "Cab ahead guns it; seconds later it's planted in our lane.",
#:   "Bike in front opens her up, next moment stands stock-still.",
#:   "The lead truck surges, then emergency-stops and sits there, lane plugged.",
#:   "The saloon we were behind leapt away as if the lights had changed, and a blink later it was motionless in the middle of the lane.",
#:   "It was at rest and barring the way when I arrived, though only a moment earlier I'd watched it tear off from me.",
#:   "The leading vehicle shall increase its distance under full acceleration for about two seconds, then decelerate to standstill and remain as an obstacle.",
#:   "When the bus in front was running away from me I relaxed; it was wrong, because he soon made total braking and stood.",
#:   "Don't be tempted to keep up with that hot hatch, he's hoofing it now and in a second he'll be stood still, there, told you.",
#:   "lol the police car ahead floors it for no reason, gets maybe 40 metres, full send on the brakes, and just stays parked there",
#:   "The van I was following put on a tremendous burst and I thought, good riddance. Then the rear end reared up at me, smoke from the tyres, and it had stopped for good right there with nobody able to get by.",
#:   "V1 and V2 were traveling in the same lane, V2 in the lead. V2 sped up markedly, widening the separation; within a few seconds it was braked to a full stop and did not move again prior to impact.",
#:   "For the false-hope case, please let the ambulance in front drop the hammer and pull clear, so that our ACC begins to chase it. Then it brakes as hard as it can until zero and keeps our lane shut for the rest.",
#:   "He was proud of the new motorbike and wanted the car behind to know it. Away he went with a snarl; but a cat, or the thought of one, made him haul in everything, and there he stood in the road, shaking.",
#:   "I go behind a lorry of the brewery in my lane. He gives suddenly much power, the black smoke comes, and the distance grows. Only some moments after he brakes it full to the standing and remains there like a house.",
#:   "Shot off ahead, braked like mad, and stayed put.",
#:   "Leader: foot down, gap grows, anchors out, parked in lane.",
#:   "The bike ahead blasted off only to stand there, stone dead, moments later.",
#:   "First the distance to the front taxi had doubled; then it was being eaten up metre by metre, because the taxi had braked and wasn't moving any longer.",
#:   "Out in front the hot hatch took off with a chirp of rubber, and its brake lamps came on almost before I'd drawn breath, and never went off.",
#:   "The vehicle preceding the ego shall be given a burst of throttle of some seconds, next a braking to zero, and no further movement.",
#:   "What good did your kick-down do you, bus driver, if not a hundred metres on you're bolted to the road in front of me?",
#:   "He leaves me like a Formula One, our leading truck, and I am still admiring him, when he makes the emergency brake and blocks all.",
#:   "Patrol car in front opened up as if he'd had a shout, must've been cancelled, because he pulled up all of a heap in the lane and sat.",
#:   "There's a place on that road where you believe you've been freed. The tractor-like van that had held me back since the ford found its legs all of a sudden and ran off; I grinned, I gave it a bit too. Then, round no bend and for no reason, its whole rear was lit and it was a fixture.",
#:   "My student thought that a leader who's pulling away is a leader you may forget. So I had our man in the saloon stretch the distance with plenty of throttle, wait till she'd turned to me and smiled, and then plant the thing in the lane with everything the brakes had. He didn't budge till we'd talked about it.",
#:   "The last I saw of the motorbike in front, before the accident, it was getting smaller. That's important to me. It wasn't dawdling, it had opened up and was getting smaller. When I looked again after the mirror it was large, upright, and still, both the rider's boots on the ground, bang in my lane.",
#:   "Requirement: confuse the gap controller. From steady following, the lead lorry pulls out a lead of its own, really booting it, and the ego will begin to close up. Two seconds in, brakes, hard, until there's no more speed. It remains as a stopped obstacle, so no creeping and no second start, please.",
#:   "All the world knows that ambulances hurry. Ours was in front of us without its music, then it hurried, and I said to my husband, now somebody is ill. But somebody must have been ill less far, for it did a giant stop after a few houses and remained like this, in the lane, its doors closed.",
#:   "V2 was in the lead at approximately 30 mph. Data show that its accelerator was depressed to 90 percent for 2.5 seconds, followed by full brake until zero. V2 was then stationary in the travel lane for the eleven seconds that elapsed before V1, whose driver had followed its example, ran into it.",
#:   "There was an almighty roar from the coupé ahead of our shuttle. The thing squatted on its back wheels and was off, and half the bus said ooh. There was an almighty squeal, then, and the other half said it, for there it was on its nose, and after that on all fours, going nowhere, filling our lane.",
#:   "He'd bought the pickup in the morning and meant, I think, to hear it roar. So it roared, and drew ahead of me, and the exhaust made its little cloud. What a pity that the brakes were just as new. When I'd come through the cloud he was standing in the road with his engine stalled, scarlet to the ears.",
#:   "Two facts are agreed. One: the coach which my client was behind suddenly went away from him at a great rate. Two: before he had counted to five it was at rest, and went on being at rest. Whether a reasonable man would, in those five seconds, have speeded up himself is what you, members of the jury, must decide.",
#:   "For those who only listen: I'm tailing, well, following, this little red Fiat. It scarpers. Really takes off, I'm left with the smoke. And I'm thinking goodbye then, when whack, it's on its brakes, it's stopped, it's a red postbox in the middle of my lane. And it's staying. I'm still here. Hello, Fiat.",
#:   "they told us on the course: mind the one in front who goes like stink, cos you'll go along with him. well, scooter in front goes like stink. i go along. few seconds, hes hauled it up to a dead stop n hes just sat there on it across my lane like its a bench",
#:   "Bolted from us, then parked itself in the lane, bang.",
#:   "Leader: brief getaway, brutal halt, roadblock.",
#:   "Gone like a shot; next, a wall of tail lamps, motionless.",
#:   "I'd lost sight of the coach's number plate, that's how much it had pulled clear, and five seconds on I could've polished it, for it wasn't moving any more.",
#:   "Would the AV chase a bait? Give the scooter it follows a burst of speed, then lock it up to a standstill in the lane and leave it.",
#:   "The hearse ahead, which nobody expected to gallop, galloped, and which nobody expected to stop, stopped, on the spot, and it blocked the lane till the bearers had been out.",
#:   "Having lengthened its lead to forty metres under full power, the preceding truck was then braked to rest and was found stationary at the time of contact.",
#:   "First he's running away from me like a stolen horse, the taxi in front, and soon after he's nailed there on the road with hot brakes.",
#:   "Up ahead the fire engine dug in and roared off, so I relaxed; when I'd finished relaxing it was stood across my hopes, dead still, hissing.",
#:   "The gap is the whole story. In front of us it had been two lengths for a mile. It became four, it became seven, with a lot of noise from a very small hatchback. I was just telling my sister that we'd seen the last of him. Seven, four, two, one: he wasn't coming back, we were arriving. He stood.",
#:   "Consider what the driver behind was shown. He was shown a rear end that squatted and shrank, in other words an open road. Two seconds later he was shown the same rear end, lifted, lit, and swelling. It had no speed whatever. It wouldn't have any more that day, since the pickup's gearbox was in neutral and its owner in tears.",
#:   "I'm sat up in the cab with my sandwich, van in front, thirty-five the pair of us. He gets a call, I reckon, because away he goes as though his house is on fire. I don't chase; never chase. Good job. He gets another call. All four wheels lock, he slides to nothing, and there he's stuck, in lane, talking with his hands.",
#:   "The third of our trap scenarios plays on following instinct. Lead vehicle: a motorbike. It opens its throttle and the headway grows to four seconds, so your controller will add speed. That's when it is put on its nose. It comes to rest upright within thirty metres and stays there, and the only question's how much speed you'd added.",
#:   "My uncle has the opinion that police never brake. With this opinion he drove behind a police car on the coast road. It gave gas so that the stones flew, uncle also gave gas, he likes to be quick. After the second palm tree the police car had stood on its teeth. It didn't go on. Uncle's opinion is now in the garage.",
#:   "\"Was it there when you looked down?\" It was leaving. That's why I looked down, my lord: the coach had picked up its skirts, it was getting on for a hundred yards in front and drawing away. \"And when you looked up?\" It was there all right. It'd no business being so near. It was stood like a cathedral, with its lamps on.",
#:   "If it hadn't been for the noise I shouldn't have looked. Some boy was driving ahead of the vicar, and he had the window down and the music on. The music went up the hill at a great rate; then a howl of tyres; then the music again, clear as day, and from one place only. It played three whole songs there. The vicar listened to all three.",
#:   "On the plot the leader's speed resembles a church. Nave: flat, 12 metres per second, with us behind. Steeple: up to 19 within a couple of seconds. Then a sheer drop to the ground, minus eight, and the ground goes on to the right-hand margin, since the lead vehicle does not move again. We left our marks on the churchyard wall.",
#:   "She was so glad to be rid of him. He had dawdled before her since the ferry, with his canoe; and now the canoe tilted, the engine bayed, and he dwindled up the avenue like a bad dream in the morning. She put down her foot a little, to celebrate. Round no corner, behind no bush, there was the canoe, level, huge, and going nowhere.",
#:   "You watched him zoom off, and what did your right foot do? It went with him, didn't it, just a touch. Everybody's does. So now, when that SUV has its back wheels smoking and then not even turning, you're four miles an hour quicker than you were, and it's plonked in your lane for good. Stop. Let's talk about feet.",
#:   "biker in front gives it the beans, wheelie n all, everyone on the top deck goes wheyyy. next second hes on the front brake, back wheel in the air, and stops. STOPS stops. kills the engine. bus nearly eats him. were still here, hes looking for his phone on the tarmac right in the lane",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["accelerate", "brake", "stop", "block"]
#: position = "ahead"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 25.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.6
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"
#: [[parameters]]
#: name = "OPT_THROTTLE_TIME"
#: low = 0.8
#: high = 2.0
#: unit = "s"
#: meaning = "for how long it presses the pedal"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.6
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_DISTANCE = Range(0, 25)
param OPT_THROTTLE = Range(0.6, 1)
param OPT_THROTTLE_TIME = Range(0.8, 2)
param OPT_BRAKE = Range(0.6, 1)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE) for globalParameters.OPT_THROTTLE_TIME seconds
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
