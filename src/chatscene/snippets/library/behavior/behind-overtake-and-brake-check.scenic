#: description = "The car behind swings out, overtakes the ego, moves back in front of it and brakes."
#: rephrasings = [
#:   "He swings round us from behind, gets back in and stamps on the brake.",
#:   "Vehicle 2 pulled out from behind, passed, re-entered ahead of vehicle 1 and decelerated.",
#:   "From rear: out, by, in, brake.",
#:   "The target leaves the lane behind the VUT, overtakes, returns ahead of it and brakes.",
#:   "From back he goes out, overtakes, comes again before us and brakes.",
#:   "The motorbike hops out of our wake, loops in front and grabs the lever.",
#:   "A van launches itself round us and retaliates with its brakes.",
#:   "Fed up with trailing us, the pickup leapfrogs and slams to a near stop.",
#:   "The bloke on my tail pulled out, shot round me, tucked back in and then jumped on the anchors right in my face.",
#:   "The suspect sedan, which had been traveling to the rear of the victim, passed her, returned to her lane and intentionally applied its brakes.",
#:   "Follower passes ego -> back into lane ahead -> brakes hard. Spite brake.",
#:   "The following target performs a pass of the VUT, re-enters the VUT's lane in front of it and decelerates.",
#:   "Motorbike was behind me, he goes around me, comes again in my lane before me and makes brake.",
#:   "Aggressive follower: pass, merge back ahead of us, then punish-brake; check the AEB after the lane return.",
#:   "He had been stuck behind her for a mile; then he swung round her, planted himself in front and stamped on the pedal just to teach her a lesson.",
#:   "That one behind you is going to leapfrog you, drop back in ahead and give you a brake test, so leave some room for it.",
#:   "dude was behind me, whipped around, got back in front n just slammed it, like WHY",
#:   "A vengeful motorist went round the woman's car, slotted in ahead of her and stood hard on the brake, the court heard.",
#:   "The defendant, having been to my client's rear, went by her, placed himself before her and braked deliberately, did he not?",
#:   "He was following me, then he go around, come in my front and jam brake just like that, what nonsense.",
#:   "Had one on my back, he goes round me, plonks himself on my nose and stamps on it. Twenty years I've been driving.",
#:   "Retaliatory braking by former follower subsequent to passing and return to ego lane.",
#:   "ROAD RAGER PASSES ME JUST TO BRAKE CHECK ME",
#:   "The biker behind leapfrogged us and then clamped his brakes.",
#:   "Hatchback off my rear bumper: round me, in ahead, brake lights.",
#:   "Trailing rider passes ego, rejoins our lane, then sheds speed hard.",
#:   "Have the car behind us get past, move back over and slow sharply.",
#:   "First he's in my mirror, then in my windscreen, then braking.",
#:   "El coche de atrás me pass, he enters again in front, he frenar.",
#:   "The motorcyclist who had been riding at the robotaxi's back wheel moved out, got by it, resumed the lane ahead and shed most of his speed.",
#:   "Somebody sitting in my rear-view mirror lost patience, went out and past, filtered back in front of me and hauled the car down to a crawl for spite.",
#:   "I want a scene in which the saloon following the AV leaves the lane, gets ahead, comes back over and brakes with the AV now behind it.",
#:   "My lorry fills the lane, so the cabbie on my tail had to go right round it, and when he was home in front he anchored up.",
#:   "V2, initially the trailing unit, steered out to the adjacent lane, passed V1, resumed the original lane as the leader and applied the service brakes.",
#:   "Positions get swapped: our follower goes out and past us, becomes our leader by sliding back into the lane, and promptly has its brakes on.",
#:   "I was driving home from choir practice with a taxi close behind me. He drew out, came by on the other lane, settled back into mine and then, for no reason I could see, put his brakes on so that I nearly stood on my nose.",
#:   "According to the insured, the other party had been following for several minutes. It then moved out, went past her, resumed her lane a little way ahead and was brought down almost to a standstill by heavy braking, with an empty road before it.",
#:   "Prior to the event the target trails the VUT by 10 m. It changes to the free lane, gains a lead over the VUT, changes back into the lane of the VUT once clear, and is then decelerated to below 1 m/s.",
#:   "Mum says the motorbike was cross because we were slow. It was at the back of us, then it zoomed round the side, then it got in front of us again, and then its red light came on and Mum shouted.",
#:   "The cam only looks forward so you can't see him at first, he's behind me. Then the black coupe comes into the picture from the left, slides over into my lane, you think that's it, and there go the brake lights, hard.",
#:   "Out from behind, round us, home in front, nose-dive on the brakes.",
#:   "Trailing hatchback goes by, slips back into our lane and slows hard.",
#:   "Why come round from behind, rejoin my lane and then nearly stop?",
#:   "guy behind me in a Civic goes around, drifts back across into my lane and then its brake lights for absolutely no reason",
#:   "Caller says a black motorcycle that was following her got by in the other lane, came over into hers again and then all but halted, over.",
#:   "The following vehicle shall vacate the lane, pass the VUT, re-establish itself in the VUT's lane as the new lead vehicle and thereupon be braked.",
#:   "Mirror, see him? He's leaving our lane to come by, he's by, he's filing in again ahead of you, and there come the red lamps.",
#:   "He was at my back only, then from the side he took overtake, came inside my lane ahead and simply he is pressing brake.",
#:   "I'd like the biker who is trailing the AV to go out around it, fall in again ahead of it and scrub off his speed.",
#:   "I was on my way to the dialysis unit and perhaps a shade under the limit. The saloon that had been filling my mirror drew out and went along my whole length. When there was ample room it came back over to my side of the line, and with nothing ahead of it whatever its driver put it almost to a stand. I dropped my flask.",
#:   "Claim ref. 20/771. Our policyholder reports that the vehicle to her rear changed to the other lane, drew clear of her and regained her lane some ten metres in front. It then shed its speed until it was barely rolling. She avoided contact but strained her neck.",
#:   "You want to know why my shopping's all over the footwell? That motorbike, that's why. Two minutes ago he was looking at my number plate, then I was looking at his, because he'd been round me and come home into the lane, and no sooner was he settled there than his wheel was the next best thing to standing.",
#:   "What the rear camera had been showing for a kilometre, namely a silver coupe, the left camera showed for three seconds and the front camera from then on, centred in our own lane. Its brake lamps came on at a range of twelve metres. The speed curve of the coupe goes from fifteen to just under one.",
#:   "Nobody was in front of him, Officer, that is what I can't understand. He'd had all the road he wanted once he'd gone past me and crossed back over the dashes into my lane. And there he sat down on his brakes, the very man who'd been behind me since the station, and my daughter screamed.",
#:   "V2 was following V1 in the right lane. V2 moved into the left lane, overtook V1 and completed a return into the right lane ahead of V1. V2 was then decelerated to near walking pace by its operator, who told police that he \"wanted to make a point\".",
#:   "I am driving from Sevilla with my mother who sleeps. One car is all the time behind us, he puts himself to the other lane, he advances us, he puts himself again in ours. And then he makes to brake so much that my mother wakes up and asks if we have arrived.",
#:   "The tail lights that made me swear belonged to the same van whose headlights I'd been squinting at in the mirror. In between there'd been a rush of white panels down the window and a leisurely slide across from the next lane into mine. Then up came my dashboard, because he was slowing to nothing.",
#:   "So on the show today, the compliment sandwich of bad driving. Slice one, he's behind you; the filling, he hops lanes, goes around you and hops back when he's safely ahead. Slice two, he's brought the thing nearly to a stop and you've got your arm across the passenger.",
#:   "Note for the pupil's log: handled an unpleasant situation calmly. A motorcyclist who had been sitting behind us pulled wide into the adjacent lane, went ahead, resumed our lane and used his brakes firmly down to about walking speed. She kept straight and came down with him without stalling.",
#:   "It is a strange thing to be taught a lesson by a stranger. Vera had seen him in her mirror, growing impatient; she saw him again at her elbow, over the line; and she saw him a third time before her, where he had steered back in and was killing his speed, deliberately, as one puts out a cigarette.",
#:   "From my tail to my nose by way of next door, then anchors.",
#:   "First follower, then passer, then leader in our lane, then stop lamps.",
#:   "Tailing saloon rounds us, lines up ahead, nose goes down.",
#:   "The blue estate left the insured's mirror, slid along her side windows, took up the middle of her windscreen and lit its stop lamps so hard that her belt locked.",
#:   "For run 31 the chasing motorcycle goes wide of the VUT, takes the lead, regains the VUT's lane and is retarded at 5 m/s² to almost nothing.",
#:   "ok so the grey Golf thats been sat behind me hops out, comes by, hops back in my lane and basically parks it, nobody ahead of him at all",
#:   "From my backside he is going around, sirji, in my lane he is again sitting in front, and then both brakes he has squeezed for nothing.",
#:   "The room I keep ahead of me was used by the very pickup that had dogged me: it came round by the other lane, filled it and went slow-slow-slower.",
#:   "You were behind me, I told him at the lights, so why go round, settle in my lane again in front and hold me up with your brakes?",
#:   "I gave the constable one car and two number plates, so he thought I was confused. The front plate I knew from an hour of mirror. The rear plate I learned after the thing had been out and round me and had come home into the lane, because it threw all its weight on to its front wheels and I all but read it with my forehead.",
#:   "Before I'd worked out why my mirror was suddenly black, the headlamps had turned into tail lamps. There had been a motorbike beside my door in between, in the other lane, with a boot sticking out. The tail lamps drifted over till they were bang ahead of me; then they trebled in brightness and I was down to second, first, nothing much.",
#:   "Object 4 begins as \"rear, same lane, 9 m\". Forty frames later it is \"left, adjacent lane\", then \"front left\", then \"front, same lane, 12 m\", with a speed of fourteen. That speed collapses to 0.9 in two seconds although the lane before it is free; the ego, coming up on its bumper, needs 6 m/s² to stay off it.",
#:   "Nothing had been in front of me all the way from Ripon, that was the pleasure of it. The fellow at my back evidently felt he could improve on it. He got himself by on the far side, I heard him go, and he put himself in my nice empty lane, and then I had his boot lid rising in my face and my eggs on the floor.",
#:   "It's the queue behind that shows you what happened, Your Honour. My client is found almost at a stand with nothing before her except the defendant's coupe, likewise almost at a stand. Yet half a mile earlier the petrol station's camera has that coupe behind her; he'd since used the other lane to get ahead, taken his place in hers, and employed his brakes.",
#:   "The kids made a game of it in the back. \"He's behind us!\" they sang, and then \"He's next to us!\" and then, when the yellow sports car had wandered over to our side of the dashes, \"He's in front of us!\" Nobody sang after that, for his lights came on and Dad's arm shot out across me.",
#:   "I never moved out of lane one, never even touched the wheel, and still he found a way to punish me for it. You know the type, lorry lights in the mirror annoy him, only this was him annoying me: a quad-exhaust thing up my chuff. Out, along my trailer, back over in front of the cab, and then the sod stamps on it and I've eighteen pallets arriving.",
#:   "V1's event recorder shows constant speed, then a deceleration of 0.7 g with no object previously ahead. The operator explained that a motorcycle, which had been following V1, had gone by via the passing lane. It had returned to the through lane several lengths in front, and its rider had then reduced speed to that of a pedestrian.",
#:   "I have been only three weeks in England and I believed it is a custom. The man behind gives me light, he goes out, he makes the tour of my car, he comes again in our line before me. And there, when I want to wave to him, all his red lamps, and we two roll like in a funeral with nobody in front.",
#:   "Two things you did well there. When that hatchback grew tired of our company and moved out to come past, you held your line; and when it filed in ahead of us, you started easing off at once. That's why, when it stood on its nose without any reason at all, you'd the room to come down with it.",
#:   "He wanted her to see his face, she thought later, but all that he ever showed her was the back of his head. From behind, a pair of fog lamps, it had come; it had gone by a yard away, beyond the broken line; it had swung in before her. The road ahead of it was empty, and still she had to brake until they both scarcely moved.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["adjacentLane", "advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["overtake", "change-lane", "brake"]
#: maneuver = "straight"
#: place = "road"
#: position = "behind"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 11.5
#: high = 15.0
#: unit = "m/s"
#: meaning = "how fast it overtakes at most"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 1.0
#: high = 5.0
#: unit = "m"
#: meaning = "how far ahead of the ego it is when it moves over"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.6
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_SPEED = Range(11.5, 15)
param OPT_ADV_AHEAD = Range(1, 5)
param OPT_BRAKE = Range(0.6, 1)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) for 0.8 seconds
    do DrivePath(extended(adjacentLane, 20), globalParameters.OPT_ADV_SPEED) until headway(egoRoute, ego, self) > globalParameters.OPT_ADV_AHEAD
    do DrivePath(egoRoute, 8) until abs(offsetFrom(egoRoute, self)) < 1
    do BrakeOnPath(egoRoute, globalParameters.OPT_BRAKE) until self.pose[3] < 1
    do DrivePath(egoRoute, 4)
