#: description = "The car ahead stops and abruptly reverses."
#: rephrasings = [
#:   "A vehicle in front halts and rolls backwards toward the ego.",
#:   "The adversary shifts into reverse gear and backs up.",
#:   "The car stops short, then drives backward without looking.",
#:   "The driver ahead suddenly moves in reverse and blocks the lane.",
#:   "The van comes to a stand and backs into the traffic behind it.",
#:   "The fool in front stops and backs right at us.",
#:   "Vehicle 2 came to a stop and then backed toward vehicle 1.",
#:   "It stands and suddenly it goes with the reverse gear.",
#:   "The pickup in front pulled up and then, I kid you not, came flying backwards at me.",
#:   "The vehicle ahead of Unit 1 halted in the lane and suddenly backed up.",
#:   "Truck ahead halts, R gear, quick, towards us.",
#:   "The lead vehicle comes to a standstill and unexpectedly travels rearward in the same lane.",
#:   "Bus before me stands, then suddenly it drives back.",
#:   "Lead: v -> 0, then sharply negative, and it does not drive off forward afterwards.",
#:   "It had stopped, and she waited for it to go on, but it shot back at her instead.",
#:   "He's stopped up there and his reverse lights are on, back off, back off, he's coming at you.",
#:   "car in front stopped then started reversing into me like hello??",
#:   "A lorry halted ahead of the motorist and without notice shot backwards.",
#:   "The vehicle before my client came to rest and then, to his astonishment, moved upon him in reverse.",
#:   "Front car stopped and directly he put reverse, coming towards my bonnet.",
#:   "Pulls up in front, I pull up behind, next thing his boot's in my lap.",
#:   "Unexpected rearward motion of preceding vehicle after standstill",
#:   "FRONT CAR REVERSES AT ME FOR NO REASON",
#:   "The truck in front stops and recoils toward us.",
#:   "White lights, flying backward at me! He'd only just halted up ahead.",
#:   "Make the lorry in front pull up, then jerk into reverse.",
#:   "Lead bus: full halt, then sudden rearward travel at VUT.",
#:   "The saloon before us quit moving, next it charged us backwards.",
#:   "Rammed by the car I was following, which had stopped and reversed.",
#:   "A dustcart we had been following came to a halt in its lane, and without so much as a beep it began driving back at our radiator.",
#:   "The claimant had stopped behind the pickup, which had itself stopped, when its driver engaged reverse without warning and travelled rapidly back towards her.",
#:   "After reaching zero speed the leading vehicle shall, within half a second, travel backwards along the same lane at 3 m/s and not return to forward motion.",
#:   "I want the van up ahead to come to rest and then, all of a sudden, to back down the lane in the direction of the robotaxi.",
#:   "missed his exit i suppose so he pulled up dead in the carrigeway and came tearing backward with us sat right behind him",
#:   "Auto in front has halted, I also halted, and in one second fellow is in back gear and coming to kiss my bumper.",
#:   "The coach had gone past the hotel entrance, that's what I think. It stopped in front of us, I stopped as well and had barely got the handbrake on, and then the great thing was lurching backwards and its rear window was getting bigger and bigger.",
#:   "V1 and V2 were traveling in line. V2 slowed to a stop in the travel lane. Its back-up lamps illuminated almost immediately and V2 accelerated to the rear, toward the front of V1, whose operator sounded the horn.",
#:   "Lesson of the day, and I say this to every pupil: leave room behind the one in front even when he's standing. See this Corsa? It stopped, you stopped, and bang, it's in reverse and heading for us quick. Horn, now, good long one.",
#:   "The brake lights of the car ahead went on and it stood. I remember thinking how quiet the street was. Then came that whine which only a reverse gear makes, and its boot rushed up to my windscreen before I had time to be surprised.",
#:   "Lorry driver here, nothing to hide. I'd overshot the yard, so I stopped in my lane, whacked it into reverse and went back smartly. I never saw the little self-driving car that was behind me until I heard it hooting.",
#:   "Halted ahead, then shot rearwards at our radiator, did that taxi.",
#:   "Simulate a leading minibus that stops short and bolts backwards.",
#:   "Van's brake lights, standstill, white lights, boot coming at me quick.",
#:   "The lorry we were behind drew to a halt in its lane and, before half a breath was out, its tailgate was charging at us.",
#:   "Once the preceding car has been at zero speed for half a second it shall move rearward along the lane with brisk acceleration towards the VUT.",
#:   "Imagine you are stopping politely behind a coach which has stopped, and this coach takes quickly the backward gear and wants to eat you.",
#:   "Was the pickup not already stationary in front of you, madam, when all at once it began to travel the wrong way, tail first, in your direction?",
#:   "so dude overshoots his turn, stops dead in the lane in front of me and just WHIPS it backwards, my bonnet's now a different shape",
#:   "V2, in front of V1 and southbound, halted in the lane of travel and abruptly proceeded northbound in reverse until its hitch ball entered V1's grille.",
#:   "You leave a nice gap behind a skip lorry and you think the gap is yours. Mine was four metres when he'd come to a halt, I had measured it with my eye like a good lad. Then the beeper went and the gap was three, two, one, faster than I could find my horn.",
#:   "He had spotted a parking place which he'd driven past. That was the whole reason for it. The Renault in front of the insured's vehicle accordingly stopped where it was, in the traffic lane, and in the next instant raced tail-first towards the insured, who had no possibility of getting out of its way.",
#:   "My daughter keeps a list of funny number plates and she was leaning forward to read one. \"It's stopped, hold still,\" she said, and then \"It's getting bigger!\" We weren't moving at all. It was the estate car that had been in front of us all along and was now hurtling backwards with its reversing lamps on.",
#:   "Oscar Two, er, the suspect's realised it is a dead end. He's stopped, about a car's length ahead of me. Stand by. Reversing lights, he's reversing, he's coming back at me at speed in the same lane, brace, brace. Contact with the front of the unit, he's now stationary.",
#:   "The graph of range against time has three parts. Range shrinks while both vehicles slow, it is level for half a second with both at rest, and it then collapses at three metres a second though our wheels are locked. In other words the leader, having stopped, drove back at us, hard, and stopped again only when the range was gone.",
#:   "Nothing's so unnatural, she thought, as a thing which comes at you with its back. The bus had gone before them all the way from the station, it had pulled up in the empty street for no reason, and now that broad blind rear with its advertisement for toothpaste was rushing upon their windscreen.",
#:   "To this day I hold the brake with my left hand over my heart when somebody stops in front. There was no hill, so it didn't roll, it was driven: the cab came to rest, the driver's head spun round, I saw his teeth, and the cab leapt backwards with squealing wheels till our lamps were broken.",
#:   "In third gear behind a furniture lorry, then second, then first, then nothing because he's stood still. What should a learner do now, do you think? Look at those two white lights beneath the doors. He's found reverse and he's in a hurry about it, so a long blast, and hold tight.",
#:   "Test objective: verify reaction to a lead vehicle that reverses. Lead drives ahead at matched speed, brakes to zero at the marker, waits no longer than half a second, and then backs along the lane at 4 m/s for two seconds. Afterwards it is to stay where it has got to.",
#:   "Sir, actually he has forgotten to give toll money. So his truck was in front of mine, stopped, after barrier only, and in one jerk he put back gear and came full force. I was shouting, cleaner was slapping the side, but he came in straight line up to my bumper.",
#:   "What the cyclist behind our car can't have seen is why we hooted. The hatchback up ahead had come to a dead halt in the road, nothing odd in that, there's a school. What was odd is that it flung itself into reverse then, and that its wiper was suddenly close enough to count the bristles.",
#:   "Red lamps, dead halt, white lamps, boot in my grille.",
#:   "The bus ahead had stopped; next thing its engine was over our bonnet.",
#:   "Let the lead lorry come to rest, then charge tail-first.",
#:   "I was standing, handbrake on, and the gap to the car before me closed all the same, for it, too, had stood, but was now coming at me boot first.",
#:   "No sooner had the coach in front ceased to move than its beeper started and its rear bumper came hurrying towards the robotaxi.",
#:   "Having overshot his turning, the van driver up ahead pulled up in his lane, rammed the lever over, and shot back the way he had come, at us.",
#:   "The preceding target, on attaining zero, shall dwell no more than 0.5 s and be driven rearward with vigour in the VUT's direction, same lane.",
#:   "Any idea how fast four tons of dustcart can go the wrong way, when it has only this second stopped in front of your bike?",
#:   "He was in front, he has stopped, and before I could say \"what is it\" he was making marche arrière like for a race, direct on my bonnet.",
#:   "We've had words about the safe distance, you and I, and you'd kept it: two car lengths when he stopped. So why is there none now? You haven't touched a thing. Look at his lamps, the red ones have gone out and the white ones are lit, and his exhaust's blowing at us. That's where your two lengths went.",
#:   "The bumper sticker said \"If you can read this you're too close.\" I couldn't read it when the pickup came to a halt up ahead, nor for the half second it stood. I could a moment later, and it was getting easier all the time. I hadn't moved, I was stopped in my lane with both hands on the horn.",
#:   "Both event recorders agree and the argument's therefore over. V1, following, is at zero from 14:06:31. V2, in the lead, is at zero from 14:06:30. At 14:06:31 V2's gear channel changes from D to R and its throttle to seventy per cent. Impact follows at 14:06:33, with V1 still at zero.",
#:   "I was taking a photograph of the bus through our windscreen, my hobby, I've over two thousand. It had stopped, so I thought, hold still, my beauty. In my first picture it's a bus in the distance. In my third it's the letters \"-eyhoun-\" and nothing else. My son hadn't rolled an inch, he was already parked, poor lad.",
#:   "What had he forgotten? His wife, it turned out, at the filling station. So he did what a man does. He stopped his camper where it was, in the lane, with us at his heels, and before we'd so much as exchanged a glance he was howling backwards, chairs and bicycles and all, at a speed I wouldn't do forwards.",
#:   "Failure mode 6. Lead goes to standstill, ego goes to standstill behind it, controller arms \"wait for lead to depart.\" Lead does depart, alas, towards us: minus 3.5 m/s within a second, same lane. The controller, seeing the absolute speed rise, released the brake to follow, and thus we met it half-way.",
#:   "From a helmet camera, slowed down. The lorry's tailboard, with a chain hanging from it. It stops, so the chain swings forward. I stop. The chain swings back, hangs, and then it swings forward a second time, hard, away from me, which was odd until I noticed how fast the tailboard behind it was coming.",
#:   "The officer wished to know who had run into whom. It depends, I told her, on which end of a car you call the front. It'd been ahead of me all down the lane and it braked to nothing, as did I. Then his tyres chirped and he ran into me, but with his exhaust pipe, if that helps.",
#:   "Stop, said the gate-keeper, this road's shut. The word was for the van in front, and the van obeyed. What he ought to have added is a word about us, waiting behind. There was a crash of gears. Then two white lights and a ladder were flying at our windscreen, and my aunt was flying out of the passenger door.",
#:   "In the stillness after they had halted, the one car and then the other, she heard a blackbird. It was the last thing that she heard distinctly. The black saloon gave a whine, dropped its tail and hurled itself at her, blind, with its back seats foremost, and she could no more flee than the blackbird could have stopped it.",
#:   "When a truck is standing you leave some place and you drink your chai, isn't it? I had left good place. Suddenly horn, not mine, cleaner's whistle, full smoke from silencer, and where is my place? Truck had eaten it with his back side. He was coming so fast in reverse that the cup is still inside my dashboard.",
#: ]
#: adversaries = ["car", "truck", "bus"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario right-turn; own code"
#: [slots]
#: actions = ["stop", "reverse"]
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
#: meaning = "how hard it brakes first"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.0
#: high = 3.5
#: unit = "m/s"
#: meaning = "how fast it backs up"
#: [[parameters]]
#: name = "OPT_ADV_BACK_TIME"
#: low = 1.0
#: high = 4.0
#: unit = "s"
#: meaning = "for how long"

param OPT_ADV_DISTANCE = Range(-15, 20)
param OPT_BRAKE = Range(0.5, 1)
param OPT_ADV_SPEED = Range(1, 3.5)
param OPT_ADV_BACK_TIME = Range(1, 4)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.05
    do Halt() for 0.5 seconds
    do ReverseStraight(globalParameters.OPT_ADV_SPEED) for globalParameters.OPT_ADV_BACK_TIME seconds
    do Halt()
