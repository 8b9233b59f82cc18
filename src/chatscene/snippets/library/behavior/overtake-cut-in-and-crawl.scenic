#: description = "The car overtakes the ego, moves in front of it and then crawls along."
#: rephrasings = [
#:   "Overtakes us in a hurry, only to dawdle in front of our nose.",
#:   "Vehicle 2 passed vehicle 1, merged back and continued at very low speed.",
#:   "Passes, pulls in, then snail's pace.",
#:   "The target overtakes the VUT, changes into its lane and holds a low velocity.",
#:   "First he must overtake, after he goes slowly slowly.",
#:   "A bus rushes by to reach its stop and trickles along before us.",
#:   "The scooter lad whizzes round and then pootles.",
#:   "Having got ahead, the van settles at walking speed and holds the queue.",
#:   "Went past me, pulled in front and then dropped to about five miles an hour, what was the point of that?",
#:   "Unit 2 passed Unit 1, merged ahead of it and then proceeded at an unreasonably slow speed.",
#:   "Car o/takes, tucks in ahead of ego, then dawdles. No stop.",
#:   "The target passes the VUT, merges into its lane and then continues at a very low speed.",
#:   "The motorbike passes me, comes before me and after that drives so slow.",
#:   "Pass, merge, then go-slow: actor gets ahead and acts as a rolling roadblock.",
#:   "He'd been in such a hurry to be ahead of her, and once he was, he loitered along at a walking pace.",
#:   "Typical, he had to get in front of you, and now he's dawdling; just stay back behind him.",
#:   "bro overtook me just to go 10 in front of me?? why",
#:   "The motorist passed the van, took the space before it, and then ambled on at little more than a jog.",
#:   "You were so pressed that you passed her and took the road ahead of her, and then you loitered?",
#:   "He overtook and came to my front, and now he is going slow slow like Sunday walk.",
#:   "All that fuss to get by and nab my spot, and what's he do? Slows to a potter.",
#:   "Passing and merge ahead of ego with subsequent unduly low speed.",
#:   "OVERTAKES ME JUST TO DRIVE SLOWER",
#:   "The motorcycle passed us, slipped in front and languished.",
#:   "Scooter zips by, claims the space before us, then barely moves.",
#:   "Went round us, got in line ahead, now dawdling at a jogger's pace.",
#:   "The taxi leaves us behind, tucks in, and turns into a tortoise.",
#:   "From behind: pass, change to VUT lane, proceed at 2 m/s.",
#:   "Pottering along before us is the Jag that had just overtaken and pulled in.",
#:   "A pickup came up from the rear, went by on the outside, took its place at the head of our little column and thereafter hardly exceeded walking speed.",
#:   "Could you let a motorcyclist come past the ego, move across to the ego's lane and then plod on, so our car is stuck at his miserable speed?",
#:   "Subject vehicle was passed on the left by V2, which then entered its lane and continued forward, never stopping, at what the driver called a creeping pace.",
#:   "It isn't that he passed me or that he came in so early, officer, it's that he rolled along at five miles an hour once he was there.",
#:   "He has made overtaking with full honking, came into my lane in the front, and from then he is driving like he is searching for a coin.",
#:   "Don't get annoyed at the hatchback: yes, it flew past, yes, it has taken your lane, and yes, now it's tootling at ten, so just sit back.",
#:   "I'd been doing a steady thirty when a red Mini filled my mirror, swung out and swept by. It came back in ahead of me, and there the hurry ended. From that bend up to the church I was in first gear behind it, with it rolling and rolling.",
#:   "Phase one, the actor begins behind in the other lane and runs faster than the AV. Phase two, having got clear by a few metres, it merges to the AV's lane. Phase three, it drops to a crawling speed which it holds, without standstill, until the scenario ends.",
#:   "we laughed about it afterwards this fellow on a motobike, lether fringes and all, thundered past the bus, slotted himself in at the front and then went along so slowly he had to wobble his handlebars to stay up, with forty pensioners looking down at him.",
#:   "It had looked so purposeful while it was passing. But the long black car had no sooner slid across into their lane than all the purpose drained out of it, and it crept ahead of them up the avenue as if it were following a coffin.",
#:   "Why do people do it? You're in a wagon, limited to fifty-six, so they simply must get by. By they go, over they come, in front of your grille, and what then? They sit there rolling at a speed my kids beat on their scooters.",
#:   "Sails past, noses in ahead, and then barely ten miles an hour.",
#:   "Overtaker takes our lane in front and becomes a rolling cork.",
#:   "Make the biker pass us, move across before us, and putter along.",
#:   "A Lexus came up from behind in the other lane, went by, eased over to our lane a few metres ahead and thereafter rolled along no faster than a jogger.",
#:   "Having got by on the left and slid into the space before me, what did he do but trundle, on and on, in second gear?",
#:   "Target vehicle starts rearward of the VUT in the neighbouring lane, passes it, merges to its front and holds a residual speed of 8 km/h.",
#:   "By the time the SUV had gone past and slotted itself in at our head, its rush was over, and it led us up the hill at walking pace.",
#:   "He gives flasher, he goes past, he comes into my lane before my nose, and after all this theatre he drives as if on eggs.",
#:   "V2 overtook V1, changed into V1's lane ahead of it, and from that point until the exit was driven continuously at under ten miles per hour.",
#:   "We were third at the finish of our own commute, so to speak. The Alfa had been behind us at the lights; it was beside us at the florist's; at the bank it was before us, in our lane. And from the bank to the station, which is a mile, it took its time, and ours, without ever quite stopping.",
#:   "You can hear me on the recording going \"off you pop, then.\" That's when the scooter whined past on the outside. Next you hear me say \"oh, you're coming in here,\" and he does, bang in front. And after that it's four minutes of me in first gear, reading his learner plate aloud as we inch along.",
#:   "It is not illegal to be slow, said the magistrate, but it is odd to be slow in front of somebody whom you have just been at pains to pass. The defendant had come up from behind, got by and taken her place in the lane; having it, she drove at the speed of a lawnmower.",
#:   "Hear that roar on your offside? Somebody who can't wait. Right, she's by us, she's moved over to our side and there's her bumper. And now you would think she'd vanish over the hill. No, she's found her phone, and we're rolling behind her at eight, and we'll go on rolling behind her at eight.",
#:   "There were bets in the minibus that the hurrying hatchback was off to a birth. It had come racing up in the next lane, drawn clear and whipped across before our bumper. All bets were void a minute later, when we were still staring at its rear window and the driver of the milk float was gaining on us.",
#:   "Data show a negative longitudinal distance at first, so the motorcycle is to our rear; zero at 3.1 s; plus nine metres at 5 s. At that point its lane index becomes ours. From there, speed 2.2 m/s, flat, till the log ends. The AV had to come down from 12 m/s and sat behind it.",
#:   "I'm a patient man, I've got a caravan. But there was a fellow who had his moment of glory going by me on the dual carriageway with his fist on the hooter. He came across to my lane to show me his exhausts. And then, I swear, he slackened till the pair of us were doing six miles an hour, and kept it there.",
#:   "It came from the back like the wrath of God and it went on like a funeral. In between lay one short moment when the old Jaguar hung slantwise across the dashes on its way into their lane. Afterwards they had leisure to study every rust spot on its boot lid, for it crept, and they crept after it.",
#:   "Report on the delay of tour 8. The passenger car with the foreign plate first has overtaken the shuttle left. It then has sorted itself in before the shuttle, with little distance. Then it drove with about 7 km/h during the whole forest road, probably because of the deer, and it was not possible to get past.",
#:   "The ego is in its lane at 45. From the rear quarter comes a car which is quicker, and which passes. As soon as it's ahead by a car's length it shifts sideways to the ego's lane, and you then let it sink to 2 m/s and hold that, so we see how the ego copes with a moving roadblock.",
#:   "My boda passenger wanted to get down and walk. See, this taxi man hooted behind us, rushed by and threw himself into our line just in front. I thought he's rushing to a customer. But from there he was going like someone who counts the stones of the road, and we were counting with him.",
#:   "Streaks by, drops into our lane, and it's walking pace from there.",
#:   "Behind us, beside us, before us, and then hardly moving.",
#:   "Have a motorbike get by, slot in ahead, then just toddle.",
#:   "From the speed at which the Jag left us standing you'd never guess that, once over in our lane, it would have us in first for a mile.",
#:   "A taxi grew in our offside mirror, went by, filled our windscreen, and from then on refused to go any faster than a wheelbarrow.",
#:   "We were going fifty until the scooter got round us, tucked in ahead and turned our fifty into six, and six it remained.",
#:   "Initial position left rear; target passes, takes the VUT's lane at nine metres, adopts 2.2 m/s and neither halts nor regains speed.",
#:   "So keen to be in front that he flashes me, roars by, swings in, and then he's driving Miss flipping Daisy, wheels barely going round.",
#:   "He let me eat his dust, came in before my bonnet from the fast lane, and after all that hurry he was rolling like one who looks for his keys.",
#:   "There's a name for it in cycling, you attack, you get the gap, you sit up. The coupé attacked on the outside with a lot of noise. It got its gap and came across to our side of the dashes. Then it sat up, and I mean, joggers, actual joggers, were going by us on the path while we rolled along after it.",
#:   "The receipt from the car wash is stamped 15:10, and there are two miles from there to the school. My daughter waited until 15:40. I was in no jam, I'd one car ahead of me. It had been behind me at the car wash, it'd come by in a great rush, it had moved across in front, and it had then lost interest.",
#:   "Speed trace of vehicle B, which set out behind us. First part: 70 km/h in the neighbouring lane, our distance to it going from minus thirty to plus ten. Second part: lane change to ours. Third part: a flat line at 7 km/h, forty seconds of it, never touching zero. Ours is a mirror image, we came down from 50.",
#:   "\"He'll be gone in a minute,\" said the nurse, of the noise coming up on the outside. It went by, it was a motorbike with a sidecar. It shifted over to where we were about to be. She looked at the patient, and at the clock, and at the sidecar, which was as near as ever; it was being driven as one pushes a cot.",
#:   "A plumber's van is no sports car, I know that, and I'm used to being passed. I lifted off to let her in, even. And in she came, from the other lane, neat as you like, right ahead. I went back on the gas. I had to come straight off again: her bumper was where it had been, and hardly anywhere further a minute later.",
#:   "The inspector of the bus company could not understand the graph. Up to the cemetery, normal travel. From the cemetery on, walking speed, no stop. There the convertible had emerged from our rear on the left side, let us behind, and changed to our lane in front of the nose. Up to the terminus its passengers were making selfies, and we were the background.",
#:   "What's he after, racing up behind like that? He wants out, he's out; he wants by, he's by; now he wants our lane as well, and he's in it. And this is what I was waiting for. Look at your speedo. That's not you being timid, that's him. Nine, eight, eight. We'll be staying at eight, so leave some room.",
#:   "It would be wrong to say that the SUV obstructed the ambulance out of slowness. It'd been the quicker of the two. It had come up from astern, gone past with its horn on, and returned to the ambulance's lane. Only as its leader did it become slow, and so slow that the paramedic got out to have a word, at a walk.",
#:   "The rally plate on his boot said 41. I know since I had leisure. He had flown by us out of nowhere on the other lane, we felt the wind, and he'd dived in front. And 41, I thought, that's about what he'll be doing. He was doing a tenth of it, and did so to the end of the village, always moving.",
#:   "She had been passed before, and by better cars. This one slipped up from the rear, was abreast of her for a heartbeat, and stole over the broken line into the place ahead. Thereupon, like a guest who's pushed his way to the table and finds that he isn't hungry, it merely dawdled; and she, behind, was starving.",
#:   "Simulate impatience followed by none. Start the car behind and to the side. Run it at a third more than the ego's speed until it leads by a car's length. Put it in the ego's lane. From that point take nearly all its speed away and leave it a remnant, two metres a second, which it keeps rolling at.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["overtake", "cut-in", "slow"]
#: leader = false
#: maneuver = "straight"
#: position = "behind-beside"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 11.5
#: high = 15.0
#: unit = "m/s"
#: meaning = "how fast it overtakes at most"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 3.0
#: high = 10.0
#: unit = "m"
#: meaning = "how far ahead of the ego it is when it moves over"
#: [[parameters]]
#: name = "OPT_ADV_CRAWL"
#: low = 1.2
#: high = 2.8
#: unit = "m/s"
#: meaning = "how fast it crawls"

param OPT_ADV_SPEED = Range(11.5, 15)
param OPT_ADV_AHEAD = Range(3, 10)
param OPT_ADV_CRAWL = Range(1.2, 2.8)

behavior AdvBehavior():
    do DrivePath(advLane, globalParameters.OPT_ADV_SPEED) until headway(egoRoute, ego, self) > globalParameters.OPT_ADV_AHEAD
    do DrivePath(egoRoute, globalParameters.OPT_ADV_CRAWL)
