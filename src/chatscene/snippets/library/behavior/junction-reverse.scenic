#: description = "The car enters the intersection, stops, and reverses."
#: rephrasings = [
#:   "A vehicle noses into the junction, halts, and backs up.",
#:   "The adversary rolls in, stands still, then moves backward.",
#:   "The crossing driver thinks better of it and goes into reverse.",
#:   "Having stopped on the crossroads, the car backs out again.",
#:   "The other car pulls in before the ego and then drives backwards.",
#:   "he noses out, sees it's too tight, and backs off",
#:   "Vehicle 2 stopped within the intersection and reversed.",
#:   "The truck enters in the crossing, stands, and goes with the reverse gear back.",
#:   "The daft sod drove out into the crossroads, pulled up, then started going backwards.",
#:   "Unit 2 entered the intersection, halted, and proceeded to back up.",
#:   "Bus in junction, stops, R gear, backs.",
#:   "The target vehicle moves into the conflict area, comes to rest and then travels rearward.",
#:   "Truck goes in the crossing, stands, and drives back again.",
#:   "Actor in box changes its mind: halt, then negative speed to retreat.",
#:   "It had gone out too far, so it stopped in the middle and shrank back the way it had come.",
#:   "He's in the middle of the junction and, hang on, his reversing lights are on, he's coming back.",
#:   "this bus drove into the intersection stopped and then started BACKING UP bro",
#:   "Onlookers gasped as a lorry halted midway over the crossroads and began travelling backwards.",
#:   "So having gone forward into the junction, and having halted there, you elected to go astern?",
#:   "Inside the junction he stopped and took the reverse gear, what is this yaar.",
#:   "Gets himself out in the middle, has a wobble and starts backing out of it, with me right there.",
#:   "Rearward motion of crossing vehicle after stop in the conflict area",
#:   "WHO REVERSES IN THE MIDDLE OF AN INTERSECTION?!",
#:   "The truck halts within the crossing and backpedals.",
#:   "Lorry pulled into the crossroads, stuck there, then rolled back on its reversing beeper",
#:   "The silly car went in the crossing, stopped and drove bum first!",
#:   "Make the van enter the junction, come to rest and retreat in reverse gear.",
#:   "Why drive into an intersection only to halt and back out?",
#:   "Agent into conflict zone, full stop, then astern.",
#:   "The bus driver realised halfway out that he'd never make the bend; he pulled up inside the crossroads and put the thing in reverse.",
#:   "After entering from the side road V2 came to a standstill in the middle of the junction, whereupon its operator selected reverse and moved off rearwards.",
#:   "Our robotaxi must cope when a pickup comes out into the intersection, stands there for half a second and then travels tail first.",
#:   "It was only when her white lamps came on that I understood: the lady had driven in, changed her mind, stopped, and was now coming out backwards.",
#:   "In the middle of crossing the taxi he makes stop, and after this he is going with his back in front, very dangerous.",
#:   "Units be advised, box truck has gone into the intersection, come to a halt, and is now rolling backwards with no banksman.",
#:   "He must have missed a no-entry sign. One moment he was driving into the junction like anybody else, the next he had pulled up right in the middle, and then I heard that whine a gearbox makes and he was moving backwards.",
#:   "For the record, the other party's explanation was that he wished to let a lorry by. To do so he halted his car after having entered the intersection, engaged reverse, and drove several metres backward without, as he admits, looking over his shoulder.",
#:   "The planner treats anything that is inside the junction as leaving it forward. Please add an actor which drives in, brakes down to a complete standstill, dwells briefly and then shows negative longitudinal velocity for a couple of seconds.",
#:   "I've taught people to drive for thirty years, and this one still made me gasp. The estate rolls in, stops dead in the middle as though struck by a thought, and next thing its reversing lights glow and back it goes.",
#:   "The artic's cab had poked well into the crossroads before the man behind the wheel understood that the street was too narrow. The brakes sighed, everything stood still for a breath, and then the whole long contraption began to go back.",
#:   "In he drove, stopped dead mid-junction, out he backed, beeping.",
#:   "Lorry enters crossroads, loses all forward motion, regains it backwards.",
#:   "who goes INTO a crossing, parks there, then moonwalks out again",
#:   "The bus from the side road had come to rest well within the intersection, and presently I noticed that it was growing smaller instead of bigger.",
#:   "After standstill inside the conflict zone, the target shall dwell for 0.5 s and then proceed in the rearward direction at low speed.",
#:   "I'd like a van to poke right out into the junction, come to a dead stand there and then withdraw tail foremost.",
#:   "Mid-crossing he remembered his sandwiches, or so it looked: the estate pulled up, thought for a tick, and out came the whole thing the way it went in.",
#:   "Forward, zero, minus: that's the velocity sign of the crossing pickup, all of it happening between the four stop lines.",
#:   "Respected sir, the truck entered up to the middle, there it stood, and then without any helper showing the way the driver has taken it behind.",
#:   "There is a low bridge on the far arm, and it isn't signed till you're in the junction. The tipper driver saw it when he was already out there. He pulled up with a hiss, and I knew what was coming: the two white lamps, the beeper, and that great tail swinging back the way it had come.",
#:   "We had slowed because she was crossing, and we thought no more of it. Then her wheels weren't turning. Then they were, but the wrong way round, and the Fiesta that had gone into the crossroads bonnet first was going out of it boot first.",
#:   "The claimant's wing was struck by the back of the other car and not by the front, which is the puzzle your assessor raised. The answer is that it had gone out into the intersection, had halted, and was on its way rearwards when she came by.",
#:   "A learner will do this and you have to forgive him. He's nosed the car into the middle of the junction, had a panic, brought it to rest, and because he can't bear to be stared at he has found reverse and is crawling back out.",
#:   "\"Why is it getting away from me?\" the lorry driver wondered. The hatchback that had pulled out into the crossing had stopped there, quite still, its driver with her hand to her mouth, and then its bonnet began to recede from him at walking pace.",
#:   "Item 9 of the regression list concerns assumptions about the sign of speed. An agent comes in from the crossing road, brakes to zero in the middle of the intersection, waits half a second, and from there its position starts to run backwards along its own track.",
#:   "A coach full of schoolchildren provided the entertainment. Its driver took it out into the crossroads, realised he was in the wrong town altogether, drew up, and while the children cheered he reversed it, foot by foot, past the cyclist who had just got by.",
#:   "The saloon had been so sure of itself, that was the odd thing. It had swept in between the corners, and it stood there only for as long as a man needs to swear once; after that, lit up white at the stern, it slunk back as it had come.",
#:   "On arrival the box van was behind the line again, and its driver swore it had never left. But there's a film. On it the van drives out to the centre, remains there a moment without moving and then travels the same five metres the other way in reverse.",
#:   "In France we have priority from right and so this man, he advances in the crossroad with confidence. Then he sees the tram of far, he blocks his wheels, he is immobile; and now he recoils, without to look, with me not far.",
#:   "Chat, tell me I'm not crazy. The SUV goes in, cool. It sits there in the dead middle of the intersection, less cool. And then I see gear stick movement and the thing starts shrinking, it's literally reversing with the entire junction watching.",
#:   "Its bonnet came out to us, rested, and then withdrew, beeping.",
#:   "In forwards, a breather in the middle, out again boot first.",
#:   "The bus on the crossing is standing, no, it's shrinking.",
#:   "Between the four corners the estate's wheels came to a rest, and when they began to turn again, they turned the other way.",
#:   "His white lamps came on in the middle of the junction after a moment of nothing, and the pickup sank back towards the street that had sent it.",
#:   "Have a lorry poke out over the crossing, remain there without motion for half a second, and then undo its last few metres tail foremost.",
#:   "Gears crunched, which told me what he was up to; he'd been sitting in the thick of the crossroads for a tick, and now he was off rearwards.",
#:   "V2's tracked position advanced into the intersection, remained constant for 0.6 s and thereafter regressed along the same path at about 1.5 m/s.",
#:   "The autobus comes in the crossing, he is standing like frozen, the chauffeur puts the arm behind the seat, looks backwards, and so he also drives.",
#:   "I thought we were moving. It's a feeling one gets in stations: the other train slides and you think it's yours. I'd been staring at a minibus that had come out into the junction and halted in front of us, and when its side began slipping along, nose last, it took me a second to see that it was going back.",
#:   "There was hooting, and a woman shrieked, since she was on her bicycle right behind the thing. All had been well as the van drove out, all had been well as it drew up between the four corners with its driver scratching his head. But then its tail came at her, with the two white lights lit.",
#:   "The engineer asked for a sign change. So the actor enters from the side at five metres per second, we bring it down to zero in the conflict zone, we let it hang there for half a second, and the next value on its odometer is smaller than the last. It finishes up nearer its own road again.",
#:   "What do you suppose the old gentleman had left at home? He'd nosed his Morris into the crossing in front of us and got no farther than the cat's eye in the centre. There he sat. And there he twisted round, one arm along the seat, and with a whine the Morris shrank up the street it had come from.",
#:   "Our claim is for the radiator grille of the car that was following the lorry. It had quite reasonably moved up when the lorry went out into the intersection. The lorry then stood, and the white lights on its tail came on, and my client could neither get away nor make herself heard above the beeper.",
#:   "Don't go yet. I know he's stopped, and I know there's a nice big hole in front of him. But I saw his hand go down to the lever, and he's in the middle of a crossroads, so there's only one gear he'd want. There you are, reversing lights, back he toddles, the way he came in.",
#:   "It was a dead heat, we'd both have been there at once, and he saw it first. I'll give him that. He stood his hatchback on the spot when it was well out in the junction. He might have stayed; he had no need to go hunting for the gear that took him away from us with his exhaust leading.",
#:   "The seagulls behind the refuse truck understood it before we did. They had followed it out to the centre of the crossroads, they'd settled on it while it was standing there, and they got up as one when the beeping began. It came back among them at the speed of a walk, tailgate first.",
#:   "If you only saw the last photo you'd say it hadn't got to the line. Photo three shows it at the line. In photo two it's in the very middle, wheels not turning; photo one has it entering. So between two and three it must have travelled backwards, and the witness heard the gearbox do so.",
#:   "Night, rain, amber flashing on the wet. The low-loader had swum out into the four ways and hung there, huge, while its driver compared what he saw with what he'd been told. Then a pair of white eyes opened at the wrong end of it. It drew itself in again, yard by yard, into the dark street.",
#:   "In our area lanes are small and drivers are proud. School van came out in the junction, stuck his nose in the middle, saw me, saw one handcart, and he stood. I thought now I'll go. But he has put back gear, and cleaner boy is beating on the body, aane do, aane do, bring it back.",
#: ]
#: adversaries = ["car", "truck", "bus"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["stop", "reverse"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -4.0
#: high = 26.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.0
#: high = 8.0
#: unit = "m/s"
#: meaning = "how fast it comes in"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.0
#: high = 4.5
#: unit = "m"
#: meaning = "how far beyond where their ways meet it stops"
#: [[parameters]]
#: name = "OPT_ADV_BACK"
#: low = 1.5
#: high = 4.0
#: unit = "m/s"
#: meaning = "how fast it backs up"
#: [[parameters]]
#: name = "OPT_ADV_BACK_TIME"
#: low = 1.0
#: high = 4.0
#: unit = "s"
#: meaning = "for how long"

param OPT_ADV_DISTANCE = Range(-4, 26)
param OPT_ADV_SPEED = Range(3, 8)
param OPT_STOP_DISTANCE = Range(0, 4.5)
param OPT_ADV_BACK = Range(1.5, 4)
param OPT_ADV_BACK_TIME = Range(1, 4)

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory) until self.pose[3] < 0.05
    do Halt() for 0.5 seconds
    do ReverseStraight(globalParameters.OPT_ADV_BACK) for globalParameters.OPT_ADV_BACK_TIME seconds
    do Halt()
