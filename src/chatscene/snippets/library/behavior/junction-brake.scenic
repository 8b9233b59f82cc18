#: description = "The car enters the intersection and suddenly brakes."
#: rephrasings = [
#:   "A vehicle drives into the junction and slams on the brakes.",
#:   "The adversary decelerates hard in the middle of the crossroads.",
#:   "The other driver brakes without warning when the ego expects it to go.",
#:   "The approaching car performs an emergency stop inside the intersection.",
#:   "Instead of clearing the junction, the car loses speed abruptly.",
#:   "he's nearly through and then he slams the anchors on",
#:   "Vehicle 2 entered the intersection and decelerated rapidly.",
#:   "hard braking inside crossing, no reason visible",
#:   "the car coming over the crossroads jumped on the anchors when he was already in it",
#:   "The truck had entered the intersection when its driver braked abruptly for no apparent cause.",
#:   "MC in jct: sharp brk midway.",
#:   "Once inside the junction area, the target applies an emergency braking.",
#:   "The bus goes inside the crossing and there he brakes suddenly.",
#:   "NPC: nominal approach, hard decel trigger as soon as it's past the junction entry line.",
#:   "The van was no sooner over the line and into the crossing than its nose dipped and the tyres squealed.",
#:   "He's in the junction and what does he do? Stamps on the middle pedal. Never brake in there without a reason.",
#:   "car got into the intersection n just braked for zero reason",
#:   "There were squeals of rubber as a coach driver braked midway over the crossroads",
#:   "You were already over the line and in the junction, were you not, when you chose to brake so fiercely?",
#:   "Inside the junction itself that fellow is applying sudden brake, who does like that",
#:   "He's in the box, road's clear, and he goes and stabs the brakes on, heart in my mouth",
#:   "Unexpected hard deceleration of crossing traffic inside the intersection",
#:   "Motorcycle brake-stomps IN the intersection",
#:   "The lorry nosedived on its brakes amid the crossroads.",
#:   "Cab rolls onto the crossroads, next second all four wheels are locked.",
#:   "Into the junction, then bang, full anchors. Nobody knew why.",
#:   "Have the lorry emergency-brake once it's inside the intersection.",
#:   "The coach was inside the crossing already, and there it braked so strong!",
#:   "Crossing bike chops its speed savagely mid-intersection.",
#:   "We expected the hatchback to carry on through the crossroads, but the moment it was in, its tail lifted and its speed simply collapsed.",
#:   "Set up a side-road saloon which drives into the intersection at normal pace and there, without any cue, demands maximum deceleration.",
#:   "The other motorist proceeded past the give-way line and, having got inside the junction, applied his brakes with great violence for no cause I could see.",
#:   "Halfway through his paper round the boy saw a van sail onto the crossing and then practically stand on its nose.",
#:   "If you watch the SUV, it's committed, it's in the box, and only then does the driver panic and hit the pedal as hard as she can.",
#:   "V2 passed the intersection entry at 45 km/h; skid marks beginning in the centre of the conflict zone show an abrupt application of the brakes.",
#:   "I had judged that he'd be over and away before I got there. Then his brake lights blazed in the very middle of the crossroads and all that speed was gone, and my judgement wasn't worth a penny.",
#:   "From the cab of my wagon I could see the whole junction. The little Peugeot came in from the side street quite sensibly, and once its wheels were over the line she must have seen a ghost, because she stamped on the brake for all she was worth.",
#:   "The purpose of this case is to check prediction. The agent approaches the intersection, enters it as if it would pass straight through, and then commands a sudden strong deceleration inside it, invalidating the constant-velocity assumption at the worst moment.",
#:   "I told the officer that the motorcyclist had only himself to blame. Nobody had forced him into the crossing, and nobody made him grab a fistful of front brake when he was there, with the tyre howling and the back wheel in the air.",
#:   "Lesson of the day: never trust that a bus which is going will go on going. It drove into the intersection in a nice steady way, and then some passenger must have shouted, for the driver threw out the anchors right there.",
#:   "Bike was over the line, then its front fork bottomed out.",
#:   "Crossing coach throws everything at its brakes inside the box.",
#:   "nobody hits the stoppers mid-crossroads unless they wanna be hit, HATCHBACK",
#:   "The minibus from the side street had already passed the entry line when, to everybody's astonishment, it shed nearly all its speed in a few metres.",
#:   "At a point approximately central to the junction, the crossing target transitions from constant speed to a deceleration of at least 6 m/s².",
#:   "You were waiting for that lorry to clear, weren't you, and instead he's got in there and trodden on everything he has.",
#:   "I want a crossing motorbike that looks as if it'll pass and, the instant it's within the intersection, hauls its speed down as violently as it can.",
#:   "Auf der Kreuzung, in the middle where one should be quick away, this delivery van made suddenly a full braking, I don't know for which reason.",
#:   "Two women outside the chemist's heard rubber howl and turned to see a people carrier pitching forward over its front wheels in the heart of the crossroads.",
#:   "I'd worked it out, as one does: he's coming over, he'll be gone, I can keep my speed. He did come over the line, no quarrel there. Only the gone part never happened, since his car's nose went down in the centre of the junction and the whole lot scrubbed off in a cloud of blue smoke.",
#:   "The grocer's lad told us that the tins slid the length of the van. He'd got the nod to pull over the crossing, he was well into it at a good lick, and a pigeon or a ghost or something had made him ram his foot down.",
#:   "Our expected time of clearance for the crossing truck was 1.8 seconds. It entered on schedule; then the gap between our two predicted paths stopped growing, because inside the intersection its speed had collapsed from nine to next to nothing within a second.",
#:   "Black marks begin a car's length past the give-way triangles and end near the drain cover in the centre. They were left by V2, which, according to three people, had gone into the junction unhesitatingly and then braked with all available force.",
#:   "Have you ever been behind the curtain when something heavy drops? It sounded like that. The bus had rolled into the crossroads in front of the taxi as smooth as butter, and there, right there, its driver stood on the pedal and forty passengers met the handrail.",
#:   "What the learner should take from this: entering and leaving are two separate things. The motorcyclist had entered, fine, he had the room; and then a wheel-locking grab at the lever in mid-crossing, so that anybody who had counted on his leaving was in trouble.",
#:   "It was the lights at the back of him that I saw, and they came on like a furnace door opening. He'd driven in between the four corners at thirty, if not more, and there was no earthly cause for braking at all there, let alone for braking like that.",
#:   "Dear Sir, at the junction of Mill Road I gave way as usual to a small red car from the right. It entered the junction at normal speed. I then had the fright of my life when the lady in it abruptly stamped on the brakes, in the one place where nobody should.",
#:   "From a lorry driver's seat you're looking down on roofs. This roof came gliding in from the side, got as far as the yellow hatching and jerked, I mean properly jerked, backwards under its own aerial, because the twit inside had slammed everything on.",
#:   "Regression 88: the cross agent's brake command must fire after it has passed the entry of the intersection and not before it. Last night's version braked at the line, which is a different case; here the shock is that it is already in when it decelerates hard.",
#:   "My uncle is saying always, once you have entered then finish it. But that tempo fellow had entered the crossing from the side, properly, with speed also, and then inside only he put such a brake that his back side lifted up in the air.",
#:   "He was well inside the crossroads when all four tyres started screaming.",
#:   "Crossing pickup: fine up to the middle, then anchors, hard, no cause.",
#:   "Why the nosedive, mid-junction, with nothing before you?",
#:   "The scooter was already between the four corners when its front fork sank to the stops and its speed went with it.",
#:   "We had its leaving time worked out to a tenth, and it never kept it, because once past the entry its driver trod the pedal flat.",
#:   "Give me a bus which drives into the crossing as if to clear it and, when it is over the line, sheds its speed as fast as its tyres allow.",
#:   "Black rubber, nine metres of it, and all of it lies inside the intersection; up to the kerb line V2 had been rolling freely.",
#:   "You'd let him go first, quite right, only he isn't going, he's got as far as the manhole and chucked the whole lot on.",
#:   "The driver of the lorry, he entered in the crossing with good speed, and there inside, nobody knows why, he crushed the pedal so that the load came forward.",
#:   "I'd turned my head to see if anything was behind him, because he himself was as good as through. It was the howl that made me look back. The saloon was still in the box, its bootlid in the air, and every bit of the pace that it had brought in from the side street was leaving it in smoke.",
#:   "On the pavement we all said \"ooh\". The bread van had come out onto the crossroads smartly, no dithering at the line. Then, slap in the centre, the trays inside let go, you could hear them, every last one ran forward and hit the bulkhead. The driver must have stood on it. What for, he couldn't tell us.",
#:   "The predicted occupancy of the conflict zone was 1.4 seconds. For the first half second the agent did as predicted. Its longitudinal acceleration then jumped to minus eight, well after the entry line and well before the exit, so that a zone we'd marked as soon to be free wasn't.",
#:   "Two brake lamps are burnt into my eyes. They belonged to a cab that I'd waved on, so to speak, in my mind: it had the room, it was over the line and moving nicely. They came on when it was broadside to us in the middle, and from the way its bonnet dropped she'd used both feet.",
#:   "My lesson to every apprentice at the depot is, if you're in, get out. I saw a rigid go into the crossroads at a fair lick and, where he should've been thinking about second gear up, slam on so that the cab tipped forward on its springs. And there was a little blue car on its way to that very spot.",
#:   "\"Nobody made him enter,\" said the magistrate, \"and, having entered, nobody made him do that.\" He meant the forty feet of skid which the motorcycle had drawn from just within the junction to its centre, at a moment when the plaintiff had every right to suppose that it would carry on and be gone.",
#:   "The coffee's on the dash because the robotaxi had to join in. A coach came in from the left, well ahead of us, and I remember thinking, that'll be gone. And then its back end rose and its passengers bowed, all of them at once, like a church. It was past the entry by a coach length, at least.",
#:   "I was seven and on Grandad's crossbar. There was a green car coming over the big crossing, and it was going fast, and then it made a noise like our cat and its face went down on the road. It was right in the middle. Grandad said a word, and a hubcap came rolling over to us.",
#:   "Correct behaviour would have been to keep rolling and clear the area. The other vehicle had complied up to that point, in that it came past the give-way markings at 40 km/h without a sign of doubt. The violent loss of speed that followed took place in the junction itself, where the ego least expects it.",
#:   "Chat says fake, but look at the wheel. It's turning, turning, it's past the kerb, it's in the intersection, turning, and bang, it's locked, with the SUV still doing thirty on top of it and the bumper scraping the road. No cat, no kid, no light. Somebody in there just stamped.",
#:   "See, one rule we were taught in Nagpur only: crossing means cross. This lorry was inside crossing already, half part done, and we were thinking now half part he will also do. No! Air brake, chhhhh, full force, onions coming down from the back side, and driver looking like he has seen ghost.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["brake"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 6.0
#: high = 11.0
#: unit = "m/s"
#: meaning = "how fast it approaches"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.4
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_BRAKE_DISTANCE"
#: low = 0.0
#: high = 8.0
#: unit = "m"
#: meaning = "how far before the place where their ways meet it brakes"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_SPEED = Range(6, 11)
param OPT_BRAKE = Range(0.4, 1)
param OPT_BRAKE_DISTANCE = Range(0, 8)

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < globalParameters.OPT_BRAKE_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
