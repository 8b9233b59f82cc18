#: description = "The car passes the intersection, brakes to a stop, and backs into the ego's way."
#: rephrasings = [
#:   "he's already past us, stamps on the brake and then backs right into our way",
#:   "Vehicle 2 cleared the conflict point, braked to a stop, and reversed into the path of Vehicle 1.",
#:   "passes, brakes hard, backs up into the crossing",
#:   "The target crosses the path of the VUT, brakes to a standstill and moves rearwards onto that path.",
#:   "The truck passes over, then brakes strong and comes back in reverse in front of the ego.",
#:   "A driver who missed the turning pulls up beyond the junction and rolls back into it.",
#:   "The delivery van overshoots its street, slams to a halt and reverses without looking.",
#:   "Once across, a bus halts abruptly and returns tail first.",
#:   "He'd gone right through the crossroads, slammed to a halt and then came backwards into my path.",
#:   "Unit 2 cleared the intersection, stopped abruptly and then backed into the path of Unit 1.",
#:   "Thru junction, hard stop, reverse gear, back into ego's line.",
#:   "The target clears the junction, comes to rest and subsequently travels rearward into the VUT's trajectory.",
#:   "Truck passes the crossing, brakes, stops and drives back in my way.",
#:   "Actor overshoots the junction, halts, shifts to reverse and backs onto our route.",
#:   "He was already out the other side when he realised he'd missed his street, so he stopped dead and came whining back at her in reverse.",
#:   "He's over the junction but look, white lights, he's missed his turn and he's backing up into you.",
#:   "he went all the way thru the intersection then stopped and BACKED UP into my way??",
#:   "A driver who had already cleared the crossroads halted and shunted rearward into the path of another car.",
#:   "You had passed through the junction, you stopped, and you engaged reverse so as to come back before my client?",
#:   "He crossed the junction finish already, then brake and gostan right into my path.",
#:   "Past the crossroads he is, then he drops anchor and comes at me arse first.",
#:   "Backward re-entry into ego path by vehicle that had cleared the intersection.",
#:   "TRUCK MISSES TURN, REVERSES BACK INTO INTERSECTION IN FRONT OF ME",
#:   "The van cleared the junction, halted and moonwalked into our way.",
#:   "Clears the crossroads, pulls up short, comes backwards at us.",
#:   "Bus went over the crossing, stopped hard, then reversed before our nose.",
#:   "Beyond the junction he anchors up and rolls rearwards in front of the AV.",
#:   "I'd like a van overshooting the crossroads, halting, and backing across my path.",
#:   "Missed turning: lorry through the junction, full stop, astern into our route.",
#:   "Already on the far side, the removal truck came to an abrupt standstill, selected reverse and pushed its tailgate into my line of travel.",
#:   "The post van was past the crossing already, no problem, but then it made a strong stop and drove with the back into my way.",
#:   "Once the other vehicle has left the junction it shall be braked to zero and then moved rearwards until it obstructs the subject vehicle.",
#:   "Thought he was out of the way, didn't you? Well, he's pulled up over there and he's reversing slap into your path.",
#:   "How could I have expected that a coach which was done with the intersection would jam on its brakes and come back tail end foremost?",
#:   "The thing blocking us got there in reverse: it had driven clean over the crossroads, and stamped to a halt on the other side.",
#:   "I waited for the taxi to go over, and over it went. But it seems his fare lived in the road behind, because he skidded to a stop past the crossing and backed up without a glance, right where I was heading.",
#:   "According to the witness at the bakery, V2 had entirely traversed the intersection. It then braked to rest, its backup lamps came on, and it traveled rearward into the space that V1 was about to occupy.",
#:   "The planner drops the crossing truck as soon as it's through, and that's the bug. Please have it brake to nothing just after the junction and then return in reverse gear onto our trajectory, so that the track must be revived.",
#:   "Grandad saw it better than me. The furniture lorry had got all the way over when the mate shouted something; it stood with a hiss of air brakes, and then it came shuffling backwards, bleeping, until our way was shut.",
#:   "We are in the taxi, the minibus passes by the crossing in front, good. Then the driver is remembering something, he makes full brake till he stands, and he comes in reverse exactly where we want to go.",
#:   "Over the crossroads, anchors, standstill, and back it comes across our bows.",
#:   "Had cleared the junction already; braked to nothing; returned in reverse, blocking us.",
#:   "Bus misses stop beyond junction, halts hard, backs into our line.",
#:   "We thought that lorry was done with the crossing, until its brake lamps gave way to white ones and its tailboard came home across our path.",
#:   "After the pickup has gone right over the intersection, make it pull up sharply and drive backwards till it bars the ego's route.",
#:   "He was already gone through, the furniture man, then he makes a hard brake, he stays, and with the backside first he returns before my car.",
#:   "I hit the back of a coach which, ten seconds before, had been safely on the far side of the crossroads and had stood there on its brakes.",
#:   "Crossing van exits the box, decelerates to zero past it, selects R and re-enters our lane stern first; the planner had already deleted it.",
#:   "Tell me, sir, how a taxi that had left the junction behind it, and stopped, could nevertheless present its boot to my client's bumper?",
#:   "I'd waited for the dustcart to get over, and over it got, so I set off. Its brakes hissed somewhere on my right and the thing stood. Then I heard it: beep, beep, beep. They had forgotten a bin, and to fetch it they were putting the whole back end where I was about to be.",
#:   "The first clue was the smell of brakes from the far side. A minibus full of cricketers had sailed over the crossroads, been told by eleven voices that it was the wrong road, and dropped from thirty to nothing. The second clue was its rear window, growing, in the middle of our lane.",
#:   "The track history reads oddly until you picture a lost courier. Position: crosses our route, leaves it by nine metres. Speed: twelve, four, zero. Then the sign changes; it's minus two metres per second for as long as it takes the van's tail to cover our lane. We came to rest with 0.8 m to spare.",
#:   "It looked so harmless, that old estate. It crossed in front of me and I'd put it out of my mind. But the old chap in it had seen his wife waiting on the corner he had just left behind, so he trod the brake to the floor, and once he was standing he came back for her, straight over my lane, tail first.",
#:   "We were four in the car and only the child said something. \"It's coming again!\" The lorry, the one that had passed over the crossing and that we'd all stopped looking at, had jammed itself to a stop on the other side. Its reversing lamps were on. Then its bumper was where we wanted to drive.",
#:   "In my language we say, don't sell the bear before it's dead. I have seen the truck go over the junction, so I gave gas. He however has braked to zero there behind the junction and rolled backwards again on it, and his lift platform was suddenly in my windscreen. Repair 2,300 euro.",
#:   "Who'd be a driving instructor? My pupil did it by the book: wait, let the horse transporter across, off we go. It wasn't the pupil's fault that the driver pulled up short on the far side and shoved the lot back over our path without so much as a look, horses and all.",
#:   "V2 was struck in its rear bumper by the front of V1 within the intersection, although V2 had exited the intersection some six seconds prior. Its operator had missed the entrance of the plant. He applied his brakes, came to a standstill beyond the crosswalk and moved in reverse into V1's lane.",
#:   "At the junction by our church there's a signpost which you can only read once you're past it. That's how the stranger in the hire car came to do what he did: over, a squeal, dead stop by the pub, and then a long whine of a gearbox as he came arse-about-face across the front of my bread van.",
#:   "From the pillion I saw more than my son did. He was watching our light, I was watching the removal van that had just gone over. It stopped so hard that a wardrobe slid. When it began to come back at us, loading doors foremost, into the strip of road we needed, I thumped him on the helmet.",
#:   "Would you check what we predict for a vehicle once it has left the conflict zone? I'd like the bus to get fully across, then brake to a halt, wait a moment and back up until its rear overhang sits on our planned path. My guess is that we'll have forgotten it.",
#:   "Through the crossroads, brakes, stillness, then its backside returning at us.",
#:   "We'd written that lorry off; it came back tail first.",
#:   "Over, stopped hard, and back over our route in reverse.",
#:   "White lamps, where a second ago there were red ones, told me that the removal van, safely over the crossing and halted, was about to undo all of that.",
#:   "Have the bus get right through the junction, anchor up just beyond, and then undo its last ten metres backwards until its rear is barring the shuttle.",
#:   "Nobody looks at a car that has already gone by, which explains how its boot, after a sharp halt on the far side, ended up ahead of my bumper.",
#:   "The parcels driver was out of the crossroads when he read the number he wanted behind him, so on went everything, and then he shoved it rearwards over my lane.",
#:   "He has finished the junction, he makes the stop like against a wall, and then I see his back growing in the middle of my way.",
#:   "Vehicle departs conflict zone, sheds all speed immediately past it, dwells briefly and re-enters with negative velocity, ending up transverse to our planned path.",
#:   "Twice that morning the same horsebox was in my way at the same crossroads, and it had only come the once. The first time it was going over, nose first, so I waited. There was a hiss and a stamping of hooves from the other side. The second time I saw a tail, a real one, over a ramp that was coming closer.",
#:   "There is a scuff on the bakery's side of the junction, fresh rubber, two metres long, and no scuff at all on ours. That is where he brought the car to its standstill, having got clean over. How then did he come to have my headlamp in his tailgate, in the middle? By way of his gearbox, constable; look at the lever.",
#:   "You've let the pickup cross, so go. No, stop! What have you seen? That's it: he's beyond the crossing, he's nose down and not moving any more, and now there are two white lights at the back. He's forgotten something. Our bit of road is about to have a tow bar in it. There, told you.",
#:   "The lady with the satellite voice is to blame. \"Turn around when possible,\" it says, when the hire car has already passed by the crossing. He takes that for an order. He brakes so that the suitcases fly, he stands, and with the back first he comes to where my milk truck wants to drive.",
#:   "What I'd expected was an empty junction. The dustcart had vacated it a good five seconds earlier and, as far as I knew, was on its way to Hull. It hadn't got further than the postbox, though; one of the lads was banging on its side, it was stood there rocking, and as I set off so did it. Only towards me.",
#:   "The shuttle's passengers noticed the bleep before the shuttle did. The lorry to which it belonged had passed in front, left to right, and dropped out of everybody's mind, it being parked across the way now, all of a sudden, with smoke at its wheels. Bleep, bleep. Its tail lift was over our lane at the fifth.",
#:   "Summing up, the learned judge said it was a case of a man who changed his mind. He had got over the crossroads. He regretted it. He braked, not gently, to a stand; and he then regained the crossroads by the one gear that doesn't require one to look where one is going, so that the plaintiff's way was stopped up.",
#:   "My dad calls it doing a boomerang. The blue car flew over the crossing and we were glad because then it was our go. But it skidded till it didn't move. And it whined and came back the wrong way round, with the dog in its back window looking at us, right up to where we had to drive.",
#:   "The second camera shows what our planner forgot. From t = 0 to 3 the van goes over our route and beyond. At t = 4.5 it's at rest, having pulled six metres per second squared. From t = 5 on, its distance to the crossing point decreases again, bumper foremost, the rear one, until it covers that point. We got there at t = 7.",
#:   "I was on the kerb with my trolley. The minibus goes across, good. I hear a screech so I think, well, he's hit somebody over there; but it was only that somebody had shouted his name. He's stood still. And would you believe, he doesn't get out, he comes back for her in reverse, and that red car had to stop dead for his number plate.",
#:   "lorry crosses. lorry gone. i go. lorry NOT gone?? hes slammed on past the junction, sat there a sec n now im looking at \"LONG VEHICLE\" getting bigger, bang in the way i need to go. who taught this man",
#: ]
#: adversaries = ["car", "truck", "bus"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["brake", "stop", "reverse"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 25.0
#: high = 50.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 6.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 4.0
#: high = 7.0
#: unit = "m"
#: meaning = "how far beyond where their ways meet it stops first"
#: [[parameters]]
#: name = "OPT_ADV_BACK"
#: low = 1.5
#: high = 3.5
#: unit = "m/s"
#: meaning = "how fast it backs up"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = -1.0
#: high = 2.0
#: unit = "m"
#: meaning = "how far beyond where their ways meet it stays in the end"

param OPT_ADV_DISTANCE = Range(25, 50)
param OPT_ADV_SPEED = Range(6, 9)
param OPT_STOP_DISTANCE = Range(4, 7)
param OPT_ADV_BACK = Range(1.5, 3.5)
param OPT_ADV_REACH = Range(-1, 2)

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory) until self.pose[3] < 0.05
    do Halt() for 0.5 seconds
    do ReverseStraight(globalParameters.OPT_ADV_BACK) until distanceLeft(advTrajectory, self, advMeeting) > -globalParameters.OPT_ADV_REACH - brakingDistance(self)
    do Halt()
