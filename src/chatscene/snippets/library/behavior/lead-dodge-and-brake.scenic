#: description = "The car ahead swings out around something, comes back into its lane and brakes."
#: rephrasings = [
#:   "The car in front jinks round a pothole, ducks back in and hits the brakes.",
#:   "Vehicle 1 steered left to avoid debris, returned to its lane and decelerated sharply.",
#:   "Lead dodges object, returns, brakes.",
#:   "The target performs an avoidance manoeuvre, realigns with the path of the VUT and brakes.",
#:   "It goes around an obstacle in front of us and comes again and makes a brake.",
#:   "The motorbike ahead flicks round a manhole, straightens and grabs the brake.",
#:   "A bus before us sidesteps something on the tarmac, then checks hard once back in line.",
#:   "The driver we follow wrenches the wheel to miss a dog, rights himself and anchors.",
#:   "The one in front jinked round a pothole or something, tucked back in and hit the brakes.",
#:   "The lead vehicle steered around an object in the roadway, returned to its lane, and slowed abruptly.",
#:   "Van ahead swings out round sth, back in line, brakes.",
#:   "The lead vehicle performs an evasive lateral manoeuvre, returns to the lane and decelerates.",
#:   "Truck before me goes around a thing on the road, comes back and brakes.",
#:   "Lead: out-and-in lateral bump as if avoiding debris, followed by decel in lane.",
#:   "It skirted something she could not see, slipped into line again, and its tail lights blazed.",
#:   "Ambulance ahead's dodged something, he's back in front of you and he's braking, ease off.",
#:   "the car ahead swerved round smth on the road came back n then hit the brakes",
#:   "The car in front skirted an object, resumed its place and slowed sharply, catching the follower off guard.",
#:   "He circumvented the thing, he regained his lane, and having regained it he checked his speed hard.",
#:   "Front vehicle took a cut to avoid something, came back in line and put sudden brake.",
#:   "Skips round some bit of rubbish, hops back in line and then anchors up, make your mind up mate.",
#:   "Avoidance excursion of preceding vehicle, return to lane and consequent deceleration",
#:   "CAR DODGES DEBRIS, TUCKS IN, BRAKES - was not ready",
#:   "The bus in front sidesteps something, slots back in and brakes.",
#:   "Motorbike ahead skirts a pothole, realigns, squeezes the lever.",
#:   "Around something, back in line, brakes: that's our leader today.",
#:   "Lead SUV: lateral evasion, lane regained, deceleration.",
#:   "The bus we were behind went round a box, came back and braked.",
#:   "What was that lorry avoiding, and why brake after coming back?",
#:   "Let the vehicle in front of the ego steer around a thing lying in the road, resume its lane, and only then slow down sharply.",
#:   "The police car I was following bulged out round a dead badger, settled back into its lane and immediately had its brake lights on.",
#:   "V2, preceding V1, deviated to the left of a mattress, re-entered its lane, and applied its brakes, reducing the gap at an unexpected rate.",
#:   "The van in front makes a Bogen about a thing on the street, comes into the Spur again, and there it brakes strongly.",
#:   "He'd recovered his line nicely after ducking round that cone, our pickup, so why he went for the brakes then I can't say.",
#:   "Keep your distance: the artic ahead has bent his way past some timber, straightened up in our lane, and now his stop lamps are glowing.",
#:   "We'd been tailing a coach for miles. Something like a burst tyre was lying there, the coach eased its bulk out past it, and eased back, and I thought good driver. Then the whole rear of it lit up crimson and it was braking hard in front of us.",
#:   "Given a lead vehicle in the same lane, the following sequence is executed: a short excursion to the side, such as drivers make to miss an object; a return to the original lateral position; and finally a brisk braking manoeuvre, whilst the subject vehicle follows.",
#:   "My claim form had a box for \"what did the other vehicle do\", and I ran out of room. The ambulance before me went out round a ladder in the road, it came in again in front of me, and when it was straight its driver braked.",
#:   "I blame myself a bit, since I'd sped up the moment the scooter flicked out of my way. He was only dodging a drain cover, you see, and in he came again, bang in line with my front wheel, and squeezed on his brakes.",
#:   "Ticket: lead goes round debris and we drop it as a target, that's wrong. It's back in our lane two seconds afterwards and braking, and the AV has to find it all over again with far too little time left. Please see the attatched log.",
#:   "Scooter ahead hops round debris, rejoins our line, slams on.",
#:   "Lead coach bows out, tucks in again, anchors hard.",
#:   "Preceding truck skirts object, regains lane centre, brakes firmly.",
#:   "The estate in front gave something dead a wide berth, resumed its place before us, and only having done so did it use its brakes in earnest.",
#:   "In front of me the fire truck makes a bow around a hole, is again in its lane, and now comes the brake with full power.",
#:   "Program the leading pickup so that it shifts aside as if for a plank, returns to where it was, and then sheds most of its speed.",
#:   "Dispatch, the vehicle we're behind just took a wiggle round a wheel trim in lane one, it's back in lane one, and it's stopping in a hurry.",
#:   "Never mind the pothole he went round, darling, mind the brake lights you're getting now that his motorbike's back in our lane.",
#:   "Having slipped out of line to spare a hedgehog and in again before my bonnet, the ambulance checked its speed in such a manner that I nearly joined the patient.",
#:   "The following distance was good, I'd like that noted. There was a bin bag in the road, I think, and the bus ahead of me swayed out round it and then swayed in again. I'd already relaxed, you know, the fuss being over. That is when it braked, dead straight, right in front of me, as hard as buses can.",
#:   "One car's length of paint off my front bumper, and I'll tell you how. The van I'm tailing moves out a bit. I can see why, there's an exhaust pipe lying there. He moves in a bit. Fine. What I can't see is why the tail lights then come on like a furnace when the pipe's behind him.",
#:   "The track of the leading vehicle, seen from above, has the form of a shallow bulge: a departure to one side lasting roughly a second, then a convergence to the original lane. The longitudinal profile is flat throughout the bulge. Deceleration starts only after realignment and is severe, so the follower, who may have closed up, is caught.",
#:   "It's two frights for the price of one. Fright the first: the horsebox you're following lurches out to the side, missing whatever's lying there, and lurches home. Fright the second: no sooner's the driver straight than she remembers the horse and goes for the brake pedal, and her rear doors grow in your windscreen.",
#:   "In the cab you're high, so I'd seen the ladder before he did. The minibus in front of me jinked around it and got back in nicely, I'd have done no other. But once he's in line he must've looked in his mirror to see what it was, and stood on the brakes to have a think. Forty tons, me.",
#:   "Why the brake lamps? The lead vehicle had by then cleared the tyre carcass. It had deviated round the left of it, had recovered its lane, and was pointing dead ahead with an empty road before it. V1's operator had the same question, and in the time he took to ask it, V1 closed the remaining gap.",
#:   "The motorbike ahead danced. That is the word for it: a step to the side, because of some oil on the road, and a step back to the place in front of our wheel where it had been the whole morning. My sister laughed. Then the dance was over, its brake light flared, and we nearly ran it down.",
#:   "Finding 12. Our stack treats an avoiding leader as \"leaving lane\" and starts to accelerate. In the log the police SUV is out for 1.1 s, because of a box, and thereupon occupies the lane again. It then decelerates with 5 m/s². The AV meanwhile has gained 2 m/s and must brake harder than would've been needed.",
#:   "Dashcam caption: he misses the duck, I nearly don't miss him. You can see a mother duck step into the road, you see the white Golf up front curve around her and come back into lane. And then you see him realise that there were ducklings. Brakes full on. My coffee is still in the air vents.",
#:   "I was told \"follow the lorry, Wei, keep two seconds\". I keep two seconds. Lorry goes a little out because a stone is on the road, then goes in, same like before. I think it's finish. But lorry now is straight and suddenly push the brake, so my two seconds become half second.",
#:   "My old dad reckons it was a frog. Whatever it was, the saloon up the front did a smart little sidestep for it and was straight back in front of us, so he says \"nicely done\" to the fella. He'd not got to \"done\" before the fella's stop lights were on and dad was pressing the floor through.",
#:   "Round a dead fox, back before us, anchors on.",
#:   "Front bus: one bulge out, one bulge in, brake lamps.",
#:   "Our leader spared a plank, then, tidily back, didn't spare us.",
#:   "When the motorbike ahead had done skirting the manhole and sat before us once more, it squeezed so hard that its tail rose.",
#:   "Let the lead lorry make a small detour around a thing on the tarmac, recover its old line in front of us and then scrub off speed.",
#:   "We got both: first the ambulance in front heeled out round the box, and, once back where it belonged, it put its brakes on.",
#:   "Between us and the pickup there'd been a bucket on the road, which it evaded; after which there was the pickup, in line, red-lit, much nearer.",
#:   "Do you see how the saloon ahead bends out, bends in, and, as it's nicely centred, comes up at you with all lamps lit?",
#:   "V2, the preceding vehicle, deviated laterally to clear an item of debris, resumed its position ahead of V1, and decelerated strongly upon resuming it.",
#:   "It was the brakes after the wiggle that caught me out. I'd understood the wiggle: a bit of lagging was flapping about in the road, the horsebox in front of me had given it a berth and was back on the straight and narrow. I was busy with the lagging myself. Then I looked up at a horse's backside.",
#:   "I put it to you that you had ample warning. None, with respect. The coach moving out told me to look for an obstacle. The coach moving in told me that the obstacle was dealt with. The coach then being hauled down to a crawl, in my lane, a few feet before me, was what nobody had told me.",
#:   "For half a second we could see all the way to the lights, as the truck that we'd had in front of us since Dover had stepped aside for some tyre or other. Then it stepped back. The view went, as one would expect; what one would not expect is that the trailer doors then swelled up like a balloon.",
#:   "Chronology from the on-board film. 3.0: police car, centred, ahead of us. 3.6: same car half a width to the left, a traffic cone visible on the right of it. 4.5: same car, centred again, cone behind it. 4.6: both stop lamps. 5.2: bonnet down, distance to us halved. At no time did it leave for another lane.",
#:   "On the scooter ahead was a girl with a cello. You'll see what I'm getting at. She leaned out round a pothole, cello and all, and leaned in again, beautiful, like skating. I was still admiring it when she must have felt the strap go, because she braked, in line ahead of me, and I mean braked.",
#:   "As bus driver in Lyon you know the dance of the car in front. It makes a little curve to not crush the pigeon. It takes back its place before you, you say, bravo. And it freezes almost, since the lady wants to see in the mirror if the pigeon lives. My passengers were on the floor.",
#:   "Radar gave us three events and we dismissed the first two. One, lead target drifts off axis. Two, lead target returns to axis. Drifting off axis, it turned out, was the van avoiding a wheel chock, and the third event, closing rate minus nine, was the van's driver stamping on it as soon as he was straight again.",
#:   "Daddy went \"ooh\", and then \"aah\", and then a bad word. The ooh was the red car in front going round a football. The aah was it being back in front of us, neat as anything. The bad word was when its bottom lit up and it got so close that I could read the sticker.",
#:   "Advice to novices, from the operators' handbook: when a preceding vehicle sidesteps, look at its wheels upon return. Should they be locked or its rear be raised, the driver is reacting to what he has just missed and you're about to be the second thing he hadn't planned for. This exercise reproduces the case, with a heavy vehicle leading.",
#:   "Shards of a headlamp, mine, lay right behind a roll of carpet, not mine. The carpet is what the estate ahead had jinked to get past. The estate's driver told me, quite openly, that with that behind him and his car back in its lane he'd thought of the next driver who might hit it, and so had braked to stop and fetch it.",
#:   "There's a trick the eye plays on you. A swerve ahead and you think \"he's going\". So you give it a little gas, and the fire engine, which was merely getting by a fallen branch, fills your lane again, and now its rear doors aren't going anywhere, they're stopping, and where's your little gas now? On the brake, I hope.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["swerve", "brake"]
#: position = "ahead"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -5.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.5
#: high = 2.6
#: unit = "m"
#: meaning = "how far it swerves"
#: [[parameters]]
#: name = "OPT_SWERVE_TIME"
#: low = 0.8
#: high = 1.5
#: unit = "s"
#: meaning = "for how long it swerves"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_DISTANCE = Range(-5, 30)
param OPT_SWERVE = Range(1.5, 2.6)
param OPT_SWERVE_TIME = Range(0.8, 1.5)
param OPT_BRAKE = Range(0.5, 1)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do SwerveOnPath(advTrajectory, 7, globalParameters.OPT_SWERVE) for globalParameters.OPT_SWERVE_TIME seconds
    do DrivePath(advTrajectory, 6) until abs(offsetFrom(advTrajectory, self)) < 0.6
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.3
    do DrivePath(advTrajectory, 3)
