#: description = "The car makes a U-turn from the lane beside, right across the ego's lane."
#: rephrasings = [
#:   "The cab to our right whips a full U-turn across us.",
#:   "Vehicle 2 began a U-turn from the right lane and passed through the path of vehicle 1.",
#:   "U-turn out of the right lane, across our front.",
#:   "The target turns through 180 degrees from the adjacent lane, crossing the VUT's trajectory.",
#:   "It wants to go back, so it turns around over our lane without asking.",
#:   "A courier does a one-eighty in front of our bumper.",
#:   "A patrol car beside us spins about over the whole road to give chase.",
#:   "The motorbike loops round from the outer lane and heads the other way.",
#:   "The taxi next to me decided to spin right round across my bonnet to go back the other way.",
#:   "Driver of Unit 2 attempted to reverse direction from the adjacent lane, crossing directly into the path of Unit 1.",
#:   "Car in next lane flips a U, straight over our nose.",
#:   "From the neighbouring lane the target vehicle initiates a 180-degree turn intersecting the lane of the test vehicle.",
#:   "The car on my side turns around to go back and passes in front of me.",
#:   "Adjacent actor does a 180 from its lane and sweeps through ours, blocking the way while turning.",
#:   "She was running along beside the bike when its rider hauled it about and doubled back right across her.",
#:   "That patrol car alongside wants to turn around, and he's doing it from the wrong lane, right through yours.",
#:   "the car in the next lane just pulled a uey in front of me like i wasnt there",
#:   "A taxi turned back on itself from the neighbouring lane and cut across the path of a passing motorist.",
#:   "So from the lane next to the plaintiff's you wheeled about to face the other way, with his car between you and where you wished to go?",
#:   "Auto from side lane took full U-turn across me, no indicator, nothing.",
#:   "Bloke beside me forgot his fags, I reckon, because he whipped it round the other way straight over my front.",
#:   "About-face manoeuvre by adjacent-lane vehicle intersecting own lane",
#:   "IDIOT MAKES UEY FROM THE WRONG LANE - nearly T-boned",
#:   "The motorcycle in the neighbouring lane loops back across our nose.",
#:   "From the next lane it wheels right about, sweeping over ours.",
#:   "180° turn by adjacent-lane SUV; its arc cuts our lane.",
#:   "Patrol car alongside: about-face through our path, now heading back.",
#:   "The motorbike beside Mummy turned all the way round in front of us.",
#:   "Did he really reverse direction from lane two, across your nose?",
#:   "Simulate a saloon driving in the lane next to the ego that swings through a half-circle over the ego's lane to go back where it came from.",
#:   "Cab came round full circle from the kerbside lane, over the front of the robotaxi, and made off in the direction opposite to both.",
#:   "The claimant's lane was traversed by the insured, who, driving parallel to him, elected to turn his vehicle about and return whence he came.",
#:   "He drives near me in the other line, then he gives the volante everything and turns to go back, passing before my bumper.",
#:   "I was filtering on my push bike when the hatchback on my left swung itself about-face, right over the lane I was in.",
#:   "V2 was in the adjacent lane travelling the same way; it commenced turning, its path crossed V1's lane, and it ended up facing opposite.",
#:   "Here's one for the podcast. We're side by side with this police motorcycle, all nice and calm, his radio squawks, and he hooks it over the front of us in one big curve till he's looking at where he's been, and off he goes that way.",
#:   "Well, officer, the sat nav must have told him to turn around. He was in the lane on my right, a touch in front, and he hauled that Audi round over my lane, the whole hundred and eighty degrees, and I ended up looking at his passenger door.",
#:   "The manoeuvring vehicle starts in the lane neighbouring that of the subject vehicle and moves in the same direction. At the trigger it follows a tight arc of about half a circle, whose first part intersects the subject's lane, and departs with inverted heading.",
#:   "By the time the AV's brakes had bitten, the ambulance was already showing it first its flank and then its windscreen: it had spun about out of the lane next door, clean through ours, since the call it had been sent on was behind it.",
#:   "Pupils always watch what's in front, but look over your shoulder now. That moped keeping you company on the outside has seen his mate on the pavement back there, so round he comes, over your lane, all the way about, and away in the other direction.",
#:   "Alongside us a moment ago, now gone back, via our bonnet.",
#:   "From the next-door lane, one full turnabout straight through ours.",
#:   "Police bike in adjacent lane reverses heading, sweeping across us.",
#:   "A minicab that had been keeping us company on the right threw on full lock, arced over our lane and set off whence it had come.",
#:   "Adversary starts in parallel with the ego, turns about through half a circle whose arc passes over the ego's lane, and drives off the opposite way.",
#:   "He was in the other lane same direction as me, then he makes a half-tour before my hood and I see him leaving behind us.",
#:   "Ambulance neighbouring lane, redirected, swung right about across our path, heading back into town now, we had to stop hard for him.",
#:   "First I saw the scooter's tail box, then its whole side right across my lane, then its headlamp, all in the time it takes to sneeze.",
#:   "Since when does a person in the outside lane turn back towards home across whoever happens to be driving in the inside one?",
#:   "It was the wife who shouted. I'd been looking at the speed camera, and there was this Skoda that had been running beside us, only now it stood square across my bonnet, still turning. By the time I'd stopped it had got all the way about and was toddling off in the direction we'd both just come from.",
#:   "Counsel: So both of you were driving north, you in lane one, he in lane two? Witness: Yes. Counsel: And after the incident he was driving south? Witness: Yes. Counsel: And how, pray, did he get from the one to the other? Witness: Through my lane, my lord. He turned round in it, right across me.",
#:   "The lads on the forum will say I should have seen it coming. I had a Harley in the lane next to mine, chugging along. Somebody waved to him from the pub we'd passed, so he hung that big thing round in one sweep, over my lane with the footboard scraping, and went back for his pint.",
#:   "V1 and V2 were traveling in adjacent lanes with a common heading. V2's operator, having missed a store entrance, commenced a turn of approximately 180 degrees toward and over V1's lane. The front of V1 contacted the side of V2 when V2 had turned through about a third of it; V2 then completed it and departed in the reverse direction.",
#:   "When you teach you acquire eyes in your ears. I heard the tyres of the car beside us start to chirp, the way they do on full lock, and I put my own brake on before my pupil knew anything. Past our nose went a flank, a boot, and then the whole lot was going the other way.",
#:   "Our prediction head has no class for this. The agent drives in the lane to the left, same heading, two metres forward of us. Instead of keeping lane, merging or turning into a side road, its yaw goes through ninety degrees while it is over our lane, and keeps going to a hundred and eighty. It leaves opposite.",
#:   "\"He's forgotten something,\" Mother remarked placidly. The fire engine had, until then, been rumbling along at our elbow. It now came about like an ocean liner, its ladder passing slowly before our windscreen from one side to the other, and when our own lane lay empty once more the thing was bellowing away behind us.",
#:   "Listen, I cycle, I drive, I've got no axe to grind about taxis. But this cabbie was bowling along in lane two next to the bus lane I was in, a fare yelled at him from across the street behind us, and round he came, clean over my lane, the full horseshoe, to fetch her.",
#:   "An oddity of the tyre marks was pointed out by the expert. They begin in the left of the two lanes, bend to the right, traverse the whole of the lane in which the claimant was driving, and go on bending until they point back to where both vehicles had come from. Only one manoeuvre draws such a hook.",
#:   "In this use case the robotaxi shares a dual-lane road with a patrol car. The latter gets a call on the trigger, and it requires to go back. So it shall, from its own lane, describe a tight semicircle in front of the robotaxi through the robotaxi's lane, and afterwards move off with its heading inverted.",
#:   "yesterday on my way to uni this girl in a fiat 500 next to me is singing along to something. then no indicator no nothing she spins the wheel and does a whole about turn over MY lane, im standing on the brake, and shes still singing as she goes past the other way",
#:   "Side by side, then broadside on, then gone behind us.",
#:   "Neighbouring scooter swings right round through our lane, heads back.",
#:   "taxi next to me went back where wed both come from, over my bonnet",
#:   "Have the motorbike in the next lane describe a horseshoe which goes through the ego's lane, and leave with its headlamp pointing the other way.",
#:   "Control, the squad car that was running alongside us has thrown itself about over our lane and is now southbound, we nearly had his doors.",
#:   "It had been my neighbour for a mile, heading north like me; all I got of it after that was a door, a wheel, and its grille going south.",
#:   "The lady in the lane beside must have left the iron on, for she hauled her hatchback round before my nose and set off for home again.",
#:   "Adjacent-lane agent, common heading at start. Heading at end: reversed. The arc between the two passes through our lane, ahead of our front bumper.",
#:   "What sort of person turns for home out of the next lane, with you still there between him and the way back?",
#:   "I'd like it noted that I saw four sides of the same SUV in as many seconds. Its nearside, when it was keeping me company on the right. Its tail lamps, as it began to slant across me. Its offside, square on, filling my lane. And its headlights, going back towards Leicester.",
#:   "We'd the green wave and so had he, same direction, next lane. Then the full-lock squeal, you know the one, and I'm stood on the pedal while an entire fire engine slides across my windscreen from the right. When my lane was empty again I looked in the mirror, and there it was, shrinking, facing the way we'd come.",
#:   "The claimant contends that he was changing lanes. He was not; a person who changes lanes ends up facing forward. When he had gone over my client's lane from the adjacent one he was facing backward, and it was in that direction that he drove away, having taken her offside headlamp with him on the journey.",
#:   "Watch this clip twice. First time round you only notice the cammer braking and a brown flank. Second time you see the Jag on the left, level-ish, same direction, and its front wheels go hard over. It never straightens. It keeps turning till it's been through the cammer's lane and is pointing back up the hill.",
#:   "Do you know why I say never sit in someone's blind spot? That young man on the Yamaha in lane two. He thought his half of the road had nobody next to it. So when he'd missed his exit he leaned her over, came through where you and I were about to be, kept leaning, and off he buzzed behind us.",
#:   "The robotaxi's object list reads like a riddle. Track 7 is beside us with our heading. Track 7 is in front of us, at right angles, in our lane. Track 7 is on the far side with a heading opposite to ours and a growing distance behind. There was no junction, no side road and no reason to expect it.",
#:   "At the level of the pharmacy, the vehicle of police who rolled at our side receives a call. There is no place for turning, he makes the place himself: his nose passes before ours, his flank passes before ours, and when he has finished he regards Paris and we regard Lyon. My wife had the foot on a brake that does not exist.",
#:   "Gran's china was on my lap, that's why I remember it. We stopped so hard that the teapot went. All because the man in the lane beside us had spotted a parking space behind, on the other side, and simply wheeled his Rover about, through our lane with us in it, and trundled back for it.",
#:   "A trucker's view: from up here you see heads. The bloke in the Transit on my nearside looked at his phone, looked over his shoulder, and started winding his steering wheel my way, hand over hand. A merge takes a quarter turn. He didn't stop winding till his back doors had cleared my lane and he'd begun driving home.",
#:   "It wasn't coming towards you and it wasn't in front of you. No sir. It was in the other lane, going along with me. And you say you struck it at right angles? I did, because by then it was pointing at the opposite kerb. And it left? In the direction I had come from, sir, with my bumper.",
#:   "The subject vehicle is required to stop for a lane neighbour that wishes to return. From a parallel course and slightly forward position the motorcycle follows a semicircle of constant radius towards the subject vehicle's side, so that the path of the latter is obstructed for about two seconds, and then rides off rearwards with respect to it.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["advLane", "egoRoute", "rightLane"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "u-turn"]
#: side = "right"
#: leader = false
#: place = "road"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 35.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 7.0
#: high = 14.0
#: unit = "m"
#: meaning = "how far ahead of the ego it stays"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.8
#: high = 4.6
#: unit = "m/s"
#: meaning = "how fast it turns round"
#: [[parameters]]
#: name = "OPT_TURN_RADIUS"
#: low = 6.0
#: high = 7.0
#: unit = "m"
#: meaning = "the radius of its turn"

param OPT_ADV_DISTANCE = Range(12, 35)
param OPT_ADV_AHEAD = Range(7, 14)
param OPT_ADV_SPEED = Range(3.8, 4.6)
param OPT_TURN_RADIUS = Range(6, 7)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and headway(rightLane, ego, self) > 5
    do TurnOff(3.1, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_TURN_RADIUS)
    do MoveAhead(6)
