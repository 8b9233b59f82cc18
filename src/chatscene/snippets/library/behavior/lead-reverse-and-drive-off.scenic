#: description = "The car ahead stops hard, reverses a little and then drives off forward."
#: rephrasings = [
#:   "He overshoots, jams it in reverse, comes back at us and then shoots off.",
#:   "Vehicle 1 braked to a stop, backed up a short distance and departed in its original direction.",
#:   "Lead stops, backs, then forward again.",
#:   "The target brakes to standstill, moves rearward toward the VUT and afterwards accelerates away.",
#:   "The car ahead missed something, it goes back some metres and later forward again.",
#:   "The removal van in front slams to a halt, backs up to read a sign and moves on.",
#:   "A bus driver overran the stop: brake, reverse, then away down the road.",
#:   "Forward, stop, backward, forward: the driver before us cannot make up his mind.",
#:   "The car in front slammed to a stop, rolled back a yard or two, then off he went.",
#:   "The lead vehicle came to an abrupt stop, backed a short distance, and then departed forward.",
#:   "Bus ahead: emergency stop, bit of R, then D and away.",
#:   "The lead vehicle brakes to rest, travels rearward briefly and subsequently departs in the original direction.",
#:   "Truck before me stops strong, goes little back, then goes forward again.",
#:   "Lead: hard stop, short negative v, then positive v and clears; not a permanent reverse.",
#:   "It halted with a jolt, hopped back towards her a little, and then, as if nothing had happened, went on its way.",
#:   "He's overshot his turning, stopped, he's backing up a touch, there, and now he's gone on again.",
#:   "he slammed it, backed up like a metre and then just drove off??? ok",
#:   "The vehicle in front came to a violent halt, edged backwards and then went on its way.",
#:   "You stopped short; you gave ground a yard or so toward my client; you then proceeded as before. Have I that right?",
#:   "Front car jam brake, gostan a bit, then drive off like nothing happened.",
#:   "Stops on a sixpence, comes back at me half a length, then swans off up the road.",
#:   "Abrupt halt of preceding vehicle with short rearward movement and subsequent forward departure",
#:   "STOPS, BACKS UP, LEAVES. Explain this driver",
#:   "The truck in front halts, twitches backward and leaves.",
#:   "Lead brakes to nil, rolls backward a metre, then departs forward.",
#:   "Taxi before us: dead halt, short backing, then onward.",
#:   "The car in front anchors, returns a bit toward us, then proceeds.",
#:   "Alors he stops very strong, makes small reverse, then continues straight.",
#:   "Ambulance ahead pulls up sharply, backs slightly, then heads off again.",
#:   "The van we were following braked to nothing at a gateway, came backwards the length of a bonnet, and then took itself off down the road.",
#:   "Could you make the vehicle ahead of us stop with violence, go astern for a metre or two, and after that drive away normally?",
#:   "He'd slammed his bus to a standstill in front of me, I saw the white lights, he came back a little, and then on he went.",
#:   "V2, leading, was brought to a stop by heavy braking, travelled rearward about two metres toward V1, and left the scene in its initial direction.",
#:   "Poor old lorry couldn't make his mind up: anchors on, stationary, back a tad towards my bumper, into first and away he goes.",
#:   "Reports of a fire engine that stopped with a jerk ahead of a robotaxi, nudged itself backward, and moved ahead again once it had found its address.",
#:   "The satnav must have told them something. First the estate in front stopped so hard its boot came up; then there was the reversing lamp and it crept back at us, not far, perhaps a yard; and then the lamp was out and it was driving on as before.",
#:   "The lead vehicle, initially keeping its distance to the ego, is braked at a high rate to zero. After half a second of standstill it is driven backwards for a short time. Finally it selects forward gear and leaves at ordinary road speed, so that the ego can follow.",
#:   "Now tell the court what happened, in order. Well, he was in front, the pickup. He stood on his brakes and stopped. Then he backed up, towards me, only a little way, I had my hand on the horn. And then he just drove on, forwards, and was gone.",
#:   "I've had a bus do this to me on my own route. Bloke ahead missed his stop, so it's brakes on full, everybody's shopping on the floor, a quick shuffle backwards to the shelter, and then, would you believe it, nobody gets on and off he drives.",
#:   "Ticket: the planner treats the white lights as a permanent reverse and freezes. Repro with a lead truck that comes to an abrupt standstill, travels backwards at the ego for one or two seconds and then moves off ahead and clears the lane.",
#:   "Van in front: full brakes, nil speed, bit backwards, away.",
#:   "Emergency stop ahead, white lights, a step back, then off.",
#:   "Lead halts hard, creeps rearward at us, then carries on.",
#:   "Halfway to the depot the lorry in front stood on everything, came to a dead stand, dropped back on us a metre and then just rolled off again.",
#:   "Ahead of V1, V2 decelerated rapidly to zero, moved in reverse for approximately one second, and resumed travel away from V1.",
#:   "the suv ahead panic stops, rolls back at me a bit (im honking), then shifts into drive and leaves as if nothing happened",
#:   "I want the leading bus to brake violently until it's still, back towards the ego for a moment and after that go on its way forwards.",
#:   "He has stopped very suddenly before me, then some feet he came reverse, I was fearing for my bonnet, and then straight he went.",
#:   "Police unit ahead of us has hit the brakes, he's stationary, he's backing to look down that alley, negative, he's rolling on again.",
#:   "The cat's fine, before you ask. But you could see only the result from where we were: the estate in front with its tail in the air, then not moving at all, then two white lamps and its bumper coming at us by a yard or so. And when whoever was in it had satisfied themselves, the lamps went out and it trundled away.",
#:   "Range to the lead falls from fifteen metres to six, which is the emergency braking to standstill. It stays at six for half a second. It then falls to four although we ourselves are stationary, so the lead is moving backwards; lastly it opens without limit as the lead pulls off in the forward direction.",
#:   "I shall mark the places on the plan, if I may. Here the ambulance braked, with great force, and here it was at rest. From here it was driven astern towards my car, to there, no more than a stride; and from there it went forward again and out of the picture, the crew having read the house number.",
#:   "My heart did the same as that bin lorry. First it stopped, because he'd slammed on with me right behind him. Then it went backwards, because so did he, only a shuffle, beeping; and when he rumbled off down the street as though nobody had been there, it started up again.",
#:   "Insurance department, please note that contact didn't occur. The hatchback I was following was halted with squealing tyres. It afterwards travelled in reverse towards me for perhaps a metre and a half, I had time to lean on my horn, whereupon its driver put it in a forward gear and departed.",
#:   "You can always tell a stranger by the way he drives in our village. The minibus before us was one: it jolted to a halt by the pump, where nobody halts, and it reversed a couple of feet so that he might see the signpost behind the ivy. Then, wiser, it proceeded, and we after it.",
#:   "The thing not to do is pull out round him. He's braked like a lunatic, he's stopped, right, but why's he stopped? There you go, he's coming back at us, just a smidge, it was the postbox he wanted; and now he's found first and he's heading off up the road.",
#:   "Lead truck brakes strong, I also brake strong, we both stand. I think okay, accident maybe. But the white lamp behind comes, he moves backward one meter to me, so I press horn very long time, then he changes again and drives forward to leave.",
#:   "For a moment the three of them in the small car believed that the coach meant to eat them. It had been fleeing before them up the pass, and it stopped so fiercely that they slid; and while they were looking up at its great back it began to grow. It grew by a metre. Then it sighed, shrank, and was only a coach again, going on up the pass.",
#:   "Comment under the 09:41 clip: watch the brake lamps go on at full pelt and the gap close, that's him pulling up dead. Watch the bumper get bigger, that's him in reverse, a foot or two. Then watch him bugger off forwards without so much as a wave.",
#:   "Planner review, case 31. With the fire engine at zero after hard braking, the ego is right to wait, and with the reversing lights on it's right to sound the horn. But the rearward motion lasts barely a second, and the engine then sets off ahead in its original direction, so the ego needn't stand there for a further minute.",
#:   "Ahead: slammed stop, white lamps, a nudge at us, then off.",
#:   "Leading coach: anchors, standstill, two feet our way, away.",
#:   "The ambulance ahead halts, gives back a yard, carries on.",
#:   "The tow bar that I'd been following stopped short, came for my radiator, thought better of it and went off up the road with its caravan.",
#:   "Lead actor to perform in order: maximal braking to rest, half-second dwell, short astern movement towards the ego, departure along the lane at normal speed.",
#:   "minivan in front full on panics to a stop, my coffee's gone, now it's BEEPING towards me, im leaning on the horn, and then it just goes. forward. bye",
#:   "I'd stopped behind the lorry all right, it was stopping that I hadn't reckoned with, nor that it would shrink my gap in reverse before it trundled on.",
#:   "Front bus has put full brake and stood, I also stood; then little little it came on me from its back side, then again straight it has gone.",
#:   "Four pictures, officer: its brake lights, its stillness, its bumper a stride nearer to mine than it had been, and its exhaust dwindling down the lane.",
#:   "The sticker on its back window said BABY ON BOARD, and I can give you its size at any time. Small, as we drove along behind; large in one rush, when the thing was stood on its brakes to nothing; larger again, though I wasn't moving by then, and its white lights were lit; and small once more, and too small to read, as it drove on.",
#:   "Was the gap yours to keep? It was, and you kept it, you pulled up with three metres in hand when that fire engine had dropped anchor ahead of you and was stationary. And then it took one of your three metres by rolling back at you. That's no reason to reverse, mind; it wants the house we've just passed, no, it doesn't, off it trots up the street.",
#:   "My collie rides with his chin on the dashboard and he barks at things that come nearer. He barked when the van in front stopped as though it'd hit a wall. He stopped barking when it had stopped, being fair. Then he went berserk, so I looked, and there it was, stern first, creeping up on us; and then he sulked, since it had put itself in first and left.",
#:   "I teach physics, so I'd put it with arrows. Velocity of the pickup ahead of me: a long arrow up the page, a very short time, no arrow. Half a second of that. A little arrow down the page, at me, for the length of a horn blast; and then an arrow up the page again, of an everyday size, until it was out of sight.",
#:   "The file contains two photographs by the passenger. In the first there is room for a person between the defendant's tailgate and my client's bonnet, both vehicles being at rest after the defendant's violent braking. In the second, taken a second later, there would be room for a cat, and a reversing lamp is alight. There is no third, as the defendant had driven on.",
#:   "What I learned on the school run is that a bus has feelings. It was in front of us and it had a shock, boom, all its lights, and it stood there. It was ashamed and came back a teeny bit to say sorry, beep beep beep, nearly on our toes. And then it was all right again and it went on to school and so did we.",
#:   "Ego stops behind the lead, as intended, and at 4 s selects reverse to flee the approaching bumper; this is what we'd like fixed. The lead, a truck, has braked to rest at 7 m/s² and is backing only for a second, towards a missed gate. It'll be on its way down the lane by the time the ego has found its gear.",
#:   "The diesel in front of us taught me a new word for each thing it did. For its emergency stop I had one from my father. For its sitting there I had none, it was too brief. For its tail coming at my windscreen I'd one from the army, and loud; and when it pulled off up the road without so much as an indicator, I used them all again.",
#:   "Each time that I think it is finished, it isn't. The taxi in front makes a full braking until he stands, I think, so, now we wait. He doesn't wait, he comes with white light to me, one metre, I think, so, now he crashes me. He doesn't crash me, he turns to forward and drives away in his direction, and I stand there like a donkey.",
#:   "V1 came to rest behind V2, which had braked to zero in response to a perceived detour sign. V1's operator then observed V2's backup lamps and rearward movement of some four feet, sounded the horn and braced. No impact resulted; V2's backup lamps were extinguished and V2 was driven away westward, the sign having evidently been read.",
#:   "In the mountains one gets to know the rump of the vehicle ahead as a shepherd knows a ewe's. That of the post van had climbed before them all morning. It stopped, so short that their own wheels cried out; it stood; it swayed a pace downhill towards them, as if it remembered a letter; and finally, having forgotten it again, it climbed on.",
#: ]
#: adversaries = ["car", "truck", "bus", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["brake", "stop", "reverse", "accelerate"]
#: position = "ahead"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -15.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_ADV_BACK_SPEED"
#: low = 1.0
#: high = 3.0
#: unit = "m/s"
#: meaning = "how fast it backs up"
#: [[parameters]]
#: name = "OPT_ADV_BACK_TIME"
#: low = 1.0
#: high = 3.0
#: unit = "s"
#: meaning = "for how long it backs up"

param OPT_ADV_DISTANCE = Range(-15, 20)
param OPT_BRAKE = Range(0.5, 1)
param OPT_ADV_BACK_SPEED = Range(1, 3)
param OPT_ADV_BACK_TIME = Range(1, 3)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.05
    do Halt() for 0.5 seconds
    do ReverseStraight(globalParameters.OPT_ADV_BACK_SPEED) for globalParameters.OPT_ADV_BACK_TIME seconds
    do DrivePath(advTrajectory, 8)
