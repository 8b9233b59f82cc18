#: description = "The oncoming car comes the wrong way in the ego's lane, stops for a moment, and comes on."
#: rephrasings = [
#:   "he stops in our lane facing us, and then starts coming again",
#:   "Vehicle 2, travelling the wrong way, halted briefly and then resumed its course.",
#:   "wrong-way, short stop, continues toward us",
#:   "The target approaches in the lane of the VUT against its direction with a temporary standstill.",
#:   "The car in wrong direction stops a little and then it comes again toward the ego.",
#:   "A cyclist on the wrong side puts a foot down, dithers, and pedals on at us.",
#:   "The ghost driver pauses in confusion before rolling on.",
#:   "A lorry heading at us in our lane waits a second and sets off once more.",
#:   "He was on my side coming at me, stopped for a sec like he'd twigged, and then kept coming.",
#:   "The wrong-way vehicle in Unit 1's lane paused briefly, then continued toward it.",
#:   "Wrong-way in ego lane; brief halt; resumes.",
#:   "The target approaches in the VUT's lane against the direction of traffic, halts briefly and resumes its approach.",
#:   "The bicycle comes in my lane false direction, stands one moment, then comes again.",
#:   "Head-on contraflow actor with one pause; after the pause it resumes toward us instead of clearing.",
#:   "He was on the wrong side; he pulled up a moment as if it had dawned on him, and then on he came at her.",
#:   "He's coming up your lane the wrong way, he's stopped, good, oh no, he's coming on again.",
#:   "wrong way car in our lane stopped for a sec n i thought ok good but nope it kept coming",
#:   "The wrong-way bus halted briefly in the face of traffic, then resumed its mistaken course.",
#:   "You were in her lane, facing her; you stopped for a moment, and yet you came on again?",
#:   "Wrong-side car in my lane stopped little while, I thought he understood, then again he's coming.",
#:   "He's up my lane the wrong way, stops, scratches his head, and blow me, on he comes again.",
#:   "Contraflow approach in ego lane with short interruption and resumption.",
#:   "WRONG WAY DRIVER STOPS... THEN KEEPS COMING",
#:   "The wrong-way cyclist faltered in our lane, then pressed on.",
#:   "Ghost bus in our lane: comes at us, baulks, comes at us anew.",
#:   "Oncoming in the wrong lane, the pickup froze briefly, then advanced again.",
#:   "Make a cyclist ride at us in our lane, halt, think, ride on.",
#:   "Contraflow truck, ego lane, two-second standstill, onward toward AV.",
#:   "After a moment's stop the wrong-way taxi resumed bearing down on us.",
#:   "A camper van was approaching on my side of the road, dead ahead of me, and although it did stop for a breath or two, the driver then let it roll towards me again.",
#:   "Opposing target travels in the VUT's lane against its permitted direction, decelerates to rest, dwells for the specified stop time and proceeds once more in the direction of the VUT.",
#:   "The driver of V2 admitted to having been in the northbound lane while heading south, to having stopped there from uncertainty, and to having continued southbound in it all the same.",
#:   "I want an SUV meeting us head-on in our own lane, and it should brake to a halt as though it had noticed the mistake, and then keep coming anyway.",
#:   "Lorry is coming wrong side, straight in my lane, stops for small time, I am thinking thank God, and again he has started coming towards me only.",
#:   "ok hes in our lane facing us, hes stood still, so is he going back?? no he isnt hes moving up on us again the clown",
#:   "Tourists, by the plates. They were driving on the left, which was my side, and were coming straight up my lane. They pulled up, I could see them arguing over the map, and then, to my horror, the car began to come at me again in that same lane.",
#:   "All units, wrong-way vehicle on the A14, a blue artic, coming at traffic in the inside lane. It did stop, I repeat it did stop for a few seconds at marker twelve, but it has now moved off and is again running towards the oncoming cars in that lane.",
#:   "You sit in a quiet robotaxi and there's this motorbike coming up your own lane with its headlamp in your eyes. It brakes, a boot goes down, and you breathe out. The boot comes up, and there's the headlamp growing again, because he's carrying on the same way.",
#:   "It isn't the wrong-way drive as such that trips our stack up but the pause in it. The actor is in our lane, against us; it brakes to zero, which the planner reads as yielding; and just as we begin to move, it starts rolling at us again.",
#:   "For an instant reason seemed to have got the better of the old gentleman. He had been steering his Rover towards them in the lane that was theirs; he stopped it; he looked about him through the glass. And then, with a little nod, he came on towards them as before.",
#:   "Wrong-way moped in our lane: stops, ponders, keeps coming.",
#:   "Coming at us on our side, a brief halt, then onward.",
#:   "Let the contraflow bus pull up for a second, then resume towards us.",
#:   "Against all the arrows a pickup came up our lane; it checked, stood for a second or two with its lamps on us, and then went on coming.",
#:   "The opposing target, in the VUT's own lane and contrary to its direction, makes one temporary stop and thereafter resumes the approach.",
#:   "What sort of driver is on the wrong side, sees us, brings his cab to a halt, and after mature reflection continues straight at us in our lane?",
#:   "In my lane he came, in the false direction with his bicycle, then he stood, one foot down, and then he has made further toward my lights.",
#:   "V2 was northbound in the southbound lane. It came to a brief stop facing V1 and then, its operator apparently no wiser, continued northbound in that lane.",
#:   "Wrong side lorry ahead of me put brake, I said very good, now reverse he will take, but no, again he started coming in my lane only.",
#:   "They hire these little campers at the airport, and by our place they've forgotten which side is which. This one was in my lane and coming to meet me. It stood still and I saw her point to the right, quite right too, and I saw him nod. And the next thing I knew it was coming up my lane again as before.",
#:   "Two lamps, low down, where there should have been no lamps, since it was our lane and ours alone. They got bigger, then they stopped getting bigger. The AV's voice said \"obstacle has stopped\" and I thanked it. It hadn't finished the sentence when they began getting bigger again, in the same place.",
#:   "Control, vehicle on the wrong side, inbound carriageway, lane one, heading outbound. It's a coach. He's halted, he's halted in front of me, I'm going to approach on foot. Negative, negative, he's moved off again, still in lane one, still facing the traffic, coming towards me, I'm getting back in.",
#:   "Did the rider appreciate that he was in the wrong lane? We say that he must have. He'd met the plaintiff's car head-on in the plaintiff's lane, had brought his motorcycle to a standstill, and had sat looking at it. That he then rode on towards it in that lane is what makes this more than a mistake.",
#:   "I'm a ganger on the roadworks and I'd the stop board in my hand. This van ignored the cones and went up the lane that belonged to the other lot. I yelled, he stopped, a little white car was facing him. Then he shrugged at me, honest to God, and carried on up that lane towards it.",
#:   "Don't flash him, he's confused enough. He's in our lane, he's pointing at us, and he has stopped, and you'd think that's the end of it. But keep your foot on the brake, because I've seen this before: there, his wheels are turning, and he's coming on towards us, still in our lane.",
#:   "In the dwell variant, wrong-way driving is interrupted but not given up. The actor occupies the ego's lane with opposite heading, closes to the set gap, and brakes until it is at rest. After the dwell time it travels on in the same direction in which it had come, thus once more towards the ego.",
#:   "Grandma says the man in the big car had lost his way and his marbles. He was driving on our side, we could see his hat. Then his car stood and he took the hat off and scratched. Then he put the hat on and drove on, and he was still on our side, and still coming, and Grandma said a prayer.",
#:   "The fog was thick enough to lean on, and she was glad of the light in front until she understood that it was in her own lane and approaching. It halted. For some moments nothing in that grey world stirred. Then, with a crunch of gears, the truck behind the light resumed its way, and its way was hers.",
#:   "My worst day on the bus was the Marathon diversion. They'd sent me up the lane the wrong way, or I'd read it wrong. There was a robotaxi coming down it. I stopped for a moment to look at my sheet, and the sheet said straight on, so straight on I came, in its lane, nose to nose with it.",
#:   "Il roule à l'envers, in my way, this cyclist with the cap. At twenty metres he stops himself and we look one at the other. I make with the hand \"go away, go to your side.\" He has a short think. Then he mounts again on the pedals and he continues to come, in my way always, toward my bonnet.",
#:   "Nose to nose in our lane, he halts, ponders, comes on.",
#:   "The wrong-way bus stood a moment, then kept on at us.",
#:   "Let a cyclist meet us in our lane, pause, resume.",
#:   "Two lamps in my lane grew, stayed the same for as long as it takes to swear, and then went on growing.",
#:   "He must have read the no-entry sign at last, since he stopped in our lane with his grille to us, but he can't have believed it, because on he came.",
#:   "With its front to the robotaxi's front, on the robotaxi's side, the lorry made a halt as if to apologise, and took up its advance.",
#:   "The opposing target occupies the VUT's lane against the permitted direction, is brought to rest, and after the dwell time proceeds on its old heading.",
#:   "Whatever made him put a boot down, there in the middle of our lane and pointing at us, it wasn't remorse, for the boot was soon up again and he with it.",
#:   "Stay where you are, he's facing us in our own lane and he's only catching his breath, see, that's his wheels going round again, this way.",
#:   "I'd got as far as reverse. That's what I would like to be recorded, that I had taken it as settled. He had come at me on my half of the road, he'd pulled up with his bull bar looking at me, and I said to Jean, good, I'll back off and he can turn. Then the bull bar was nearer, and I hadn't moved.",
#:   "Range in metres, same lane, opposite heading, own vehicle at rest: 60, 50, 40, 30, 30, 30, 30, 24, 18, 12. The four equal ones fooled us. They were taken to be the end of the wrong-way drive, so the alarm was cleared at the third. It was raised again, in some haste, at the first of those that follow.",
#:   "The arrow on the road pointed the way we were going. We had it under our bumper. The tourist's bus had the same arrow under its own bumper, and it's fair to say they'd noticed, for they stopped on it and somebody stood up to look. After a discussion the bus began to move; and what it moved over was the arrow's tail, then the gap, towards us.",
#:   "I thought it was a mirror at first, one of those big ones at bends. A car that looked like ours was in our lane, coming. We stopped, it stopped. So it is a mirror, said my sister. We waited, it waited. And then it came on and we did not, and so it wasn't a mirror, and she screamed.",
#:   "Silver moped, inside lane, against the flow, I've eyes on. He's stopped. Repeat, he's stopped, there's a white taxi in that lane facing him, about five lengths. I think he's twigged. Wait one. No. No, he's paddling it along again, he's got his feet up, same lane, same way, straight for the white taxi. He hasn't twigged.",
#:   "It'd be a comfort if wrong-way drivers were either mad or sorry. The mad ones don't stop, the sorry ones don't start again. What I had in front of my fire engine, in my own lane, nose on, was a Nissan that seemed sorry for about three seconds. It even dipped its lights. And having dipped them it drove on at me.",
#:   "V2 was observed traveling south in the northbound lane, toward V1. Tire scuffs indicate that V2 stopped there at a distance of some seventy feet. A puddle of coolant sixteen inches wide was left under it, consistent with several seconds at rest. A trail of drops leads from the puddle farther south, in the same lane, to the point of impact.",
#:   "Let's have hope and then take it away. In the ego's lane, against the arrows, there is a lorry on its way to us. At thirty-odd metres it brakes until nothing moves. Any sensible observer would now expect it to back out, or turn. It does after a while stir; but what it does is to go on as before, at us, in that lane.",
#:   "The old general was nothing if not resolute. That the avenue had been made one-way he had been told, by his daughter among others. He met the first car of the opposing army in its own lane, and grounded his stick, so to speak, and the two surveyed each other through the glass. Then he gave himself the order, and the Daimler advanced.",
#:   "A horse knows when it's on the wrong side, a cyclist doesn't. I've the camera footage, he comes up my lane, towards me, no hands. He sees me, hands. He stops and he stands over the crossbar, and I do the polite thing, I point at his side, over there. He looks at it. He looks at me. And the pedals go round, and it's still my side that he's on.",
#:   "Arre, this is one-way, I am showing with hand, one-way! He is in my lane with his face to my face, one full mini-truck. He put brake, he is standing. Okay, brain has come. He's standing till I have finished my sentence. Then brain has gone, gear has come, and he's again rolling towards my headlight in the lane which is mine.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "wrong-way", "hesitate"]
#: position = "oncoming"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 8.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 25.0
#: high = 50.0
#: unit = "m"
#: meaning = "distance to the ego at which it pauses"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.5
#: high = 1.5
#: unit = "s"
#: meaning = "how long it pauses"
#: [[parameters]]
#: name = "OPT_ADV_OFFSET"
#: low = 0.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far toward its own side it keeps when it meets the ego"

param OPT_ADV_SPEED = Range(4, 8)
param OPT_ADV_DISTANCE = Range(25, 50)
param OPT_STOP_TIME = Range(0.5, 1.5)
param OPT_ADV_OFFSET = Range(0, 3)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < 75
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 1 and gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(against(egoRoute)) until self.pose[3] < 0.05
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 1 and gap(self, ego) < 24
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED, -globalParameters.OPT_ADV_OFFSET)
