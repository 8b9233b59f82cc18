#: description = "The car overtakes the ego, cuts in and brakes right in front of it."
#: rephrasings = [
#:   "He flies past, dives in and hits the brakes, just to teach us.",
#:   "Vehicle 2 passed, re-entered the lane of vehicle 1 and decelerated sharply.",
#:   "Pass, cut-in, brake-check.",
#:   "The target overtakes the VUT, cuts in and applies strong braking.",
#:   "He overtakes us, comes before us and makes an angry brake.",
#:   "A lorry gets by at last, swings back and stands on everything.",
#:   "The motorcyclist zooms round us and checks us hard once in front.",
#:   "A furious driver storms by, blocks us in and slams down the pedal.",
#:   "he came past, swung in ahead of me and slammed his brakes on right under my nose, brake-checking git",
#:   "Suspect passed the victim, moved in front and brake-checked him.",
#:   "MC: passes, tucks in, hard brk right ahead.",
#:   "Following the pass and re-entry into the VUT's lane, the target performs strong braking at short distance.",
#:   "The car goes by me, comes before me and then brakes very hard, I almost hit him.",
#:   "Road-rage sequence: pass, tuck in, emergency decel - all three within a few seconds.",
#:   "He had swept past, slammed the door on her, and then lit up his brake lights a yard from her bumper.",
#:   "Complainant says the biker went round her, got in front and jammed on the anchors straight away, on purpose.",
#:   "guy overtook us, went in front and brake checked us, so petty",
#:   "A feud on the road saw a motorist pass, move in and punish the follower with his brakes",
#:   "You overtook, you took the lane before my client, and you then braked for no reason but spite?",
#:   "He overtakes, comes in front and immediately puts brake, teaching us lesson or what",
#:   "Round me, in front, brake lights. Classic road rage, that. Insurance'll have a field day",
#:   "Overtaking with close lane return and immediate hard deceleration",
#:   "BRAKE CHECKED by biker who just overtook me",
#:   "The saloon leapfrogged us and clobbered its brakes.",
#:   "Biker blasts by, nips in front, and it's stoppies on our bonnet.",
#:   "Let a coupé pass the robotaxi, slice in and anchor up at once.",
#:   "He got past me, parked his rear bumper in my lap and braked.",
#:   "Pass, chop in, brake: coupé has just done all three to you.",
#:   "Il me double, he throws himself in my front and brakes like an idiot.",
#:   "First the taxi drew level and went by; next thing it was in our lane with a metre to spare, and its tail lights were glaring at us.",
#:   "A passing vehicle re-occupied the lane directly ahead of the VUT at 4 m headway and thereupon decelerated at 6 m/s², completing the triple manoeuvre.",
#:   "The motorcyclist wasn't content with having left us behind, so he veered over before our bumper and squeezed his brakes as hard as he dared.",
#:   "My rear-ending him was his own doing, given that he'd only that instant come by in the outer lane, wedged himself ahead of me and jumped on his pedal.",
#:   "See how he's going past you on the outside? He'll want back in. There, much too soon, no room, and now he's braking on top of it.",
#:   "Was it in temper that you went by her, forced your car into the few feet before hers, and there pulled your speed right down?",
#:   "Two miles of flashing his lights from the lane alongside, and then he finally gets ahead of my truck. Does he drive off? Not a bit of it: he swings his hatchback in right under my grille and stands on the brakes, so that I've got forty tonnes trying to climb over his roof.",
#:   "V2 was to the left rear of V1 in the adjacent lane and travelling faster. After completing the pass it moved into V1's lane with roughly one car length of clearance, whereupon its operator made an abrupt brake application which V1's driver avoided by steering onto the shoulder.",
#:   "I don't know what I'd done to upset the young man on the motorcycle. He came by me at the side with a rude gesture, pulled across so that his back wheel was almost touching my number plate, and then he slowed down with a jolt, on purpose, I am quite certain of that.",
#:   "Aggressor template, please: it starts in the lane next to ours, a little behind, and goes faster than we do until it has put us behind it. It then moves over into our lane with hardly any gap and immediately brakes hard, so the AV has to deal with both at once.",
#:   "Story time on the pod. I'm in a driverless cab, texting, when this red sports car goes sailing past the window. Fine. Except it then shoves itself in front, I mean tight, and bang, hits the brakes, probably for clicks, and my phone goes flying into the dashboard.",
#:   "Past me, into my bonnet's shadow, brakes. Same taxi, three insults.",
#:   "Biker on your outside: gone by, squeezed in, now hauling up.",
#:   "he zooms by, jams himself ahead of me n stomps the brake wtf",
#:   "Three seconds after her mirror drew level with mine it was her exhaust I was looking at, no gap to speak of, and above it two red lamps.",
#:   "From a slightly rearward position in the next lane, the aggressor passes the VUT, merges at 0.4 s headway and follows this up at once with heavy retardation.",
#:   "To have gone by my client wasn't enough for you; you must also claim the strip of road at her very bumper, and there squeeze your brake?",
#:   "This angry scooter, he comes from the side lane, leaves me behind, then he puts himself before my wheel and makes the brake, I almost kiss his box.",
#:   "Not content with the lane she had used to get by the campervan, the sports-car driver lunged into its lane, too close, and choked off her speed.",
#:   "Let the hatchback creep up in the neighbouring lane, outrun the robotaxi, take its lane with a metre to spare and thereupon be braked for all it's worth.",
#:   "My wife says I shouldn't have flashed him. Maybe. He'd been sat off my rear quarter in lane two for a while. I flash, and up he comes, level, ahead, and he's over in my lane with his tow bar on my number plate. Then the tow bar comes at me. That's the brake, you see, that's when you know it's personal.",
#:   "There are two skids on the road. The longer is mine. The shorter belongs to the motorcycle, and begins, if you look closely, at an angle, since it had still been coming over into my lane when he clamped on. A moment earlier it hadn't been in front of me at all; it had been at my elbow, going faster than I was.",
#:   "Unit 12, I've got the caller on the line now. She was in the right lane on the ring road when a silver car in the left lane went by her. It moved over, just about clipping her front end, and stood on its brakes. She's on the verge. She says it seemed like he wanted her to hit him.",
#:   "From the coach you see these comedies from a box seat. There was a little Fiat, minding its own business. There was a big Audi in the lane beside, behind at first, then beside, then in front. He drew his curtain over the Fiat's lane so tightly I thought they'd touched, and no sooner was it drawn than he pulled up the floor.",
#:   "A word about what \"safe\" means. Being passed is safe. Somebody moving in ahead of us is mostly safe, though not at two metres. The case that broke our controller has both of those, from the left-hand lane and in that order, and it adds a third thing: the car that's done it goes straight to minus eight.",
#:   "Daddy said a word I'm not allowed to say. It was when the motorbike man had gone whoosh past Mummy's window. He went in front of us so close I couldn't see his wheel any more, and then he made us all go forward in our belts, because he put his brakes on, and my juice went on the ceiling.",
#:   "The defendant pleads that his exit was approaching. It was four miles off. He had been in the faster lane and behind; he brought himself abreast of the coach party's minibus and then clear of it; he took its lane with, the driver estimates, the length of a broom in hand; and he put his foot on the wrong pedal with the right amount of malice.",
#:   "On our ghat road many are in hurry, but this was a different thing. The jeep took me from the side lane, blowing horn, he finished passing me, and before his back bumper had cleared my headlight he was coming inside. That also I can adjust. But inside only he put full brake, madam, and my scooter was standing on its nose.",
#:   "Notes from the passenger seat, run 6. 0:41, blue car visible in left mirror, adjacent lane, closing. 0:44, blue car has us beaten by half a length. 0:45, blue car is our lead vehicle, headway unpleasant. 0:46, its brake lamps. 0:46 and a bit, my clipboard on the floor. The safety driver says it's worse on the outside cameras.",
#:   "He must have had it planned as far back as the bridge, said the old cabbie. He hung there in the outside lane till the road was clear. Then he had me, sailed by with his hat on the back of his head, and in he popped where there wasn't room to post a letter. My taxi went down on her knees, for he'd put his brakes on dead hard.",
#:   "What does a fake crash look like from the dash cam of the mark? It begins with an overtake, from the other lane, a bit too eager. It goes on with a merge, a lot too near. And it's meant to end with your insurance details, since the thing the passing car does as soon as it's got your lane is chuck out the anchors.",
#:   "Past my elbow, into my lane, on his anchors: thanks, biker.",
#:   "dude passes me, jams in front, THEN slows to nothing. why pass???",
#:   "Sports car by you, in on you, and it's stopping. Brake! Over.",
#:   "She had no use for the lead she'd gained on us in the other lane except to bring it over in front of our bumper and there throw it away.",
#:   "Having put us behind him and himself before us, in that order and with a yard between, the man on the scooter made us all a present of his brake light.",
#:   "If it was worth his while to get by me, why was my bonnet all at once full of his boot, and his boot coming backwards, with its lamps ablaze?",
#:   "The target gains on and passes the ego in the adjacent lane, returns ahead of it at minimum headway, and is at once decelerated to below 2 m/s.",
#:   "Let the taxi come up in the next lane, quicker than we are, till it's clear of our nose by next to nothing; then in it slides, and everything it gained it brakes away.",
#:   "I lost to that hatchback twice in five seconds: once when it drew ahead of me in the outer lane, once when it dropped into my lane and dropped its speed on me.",
#:   "To end up with a number plate imprinted in your bumper you usually have to catch somebody up. I hadn't caught up with anyone. He'd caught me up, and gone by on my window side; the plate then moved over till it was dead centre and very legible, and it came to me, since he'd got both feet on the middle pedal.",
#:   "The accelerometer tells us about our car, the side radar about his. Side radar first: something on two wheels comes from abaft the beam, overhauls us, leaves the field at the front corner. Front radar: something on two wheels drops in from that very corner at four metres. Accelerometer: minus eight, because the four metres had become one, its fork being fully dived.",
#:   "She had been humming, she recalls, when a red bonnet came level with her, a red door, a red boot. She wished it good riddance. The boot, however, had not finished with her. It leaned over into her lane as if to see what she was humming, so close that she lost sight of its tyres, and then the two red lamps on it were lit, and it sank towards her.",
#:   "Jury's out on whether he knew me. I'd maybe flashed him at the merge. So he hangs on my quarter for a mile, then he's gone by in lane two and I'm thinking that's that. That's not that. I get his whole van in my face from the right, I get no gap at all, and then I get to smell his brake pads. My load's on the bulkhead.",
#:   "Für die Versicherung, the order is important. Nummer one, I'm on the right, he on the left and behind me. Nummer two, he's on the left and before me. Nummer three, he's before me in my own lane and I could touch him. Nummer four, the nose of the BMW goes down, and I do touch him.",
#:   "Overtakes are over, we teach, when you can see both his rear tyres in your windscreen and he's pulling away. Yours just now gave you the first without the second. He came by nicely. He dropped in, and no tyres, you could see no tyres at all, that's how tight he was. And pulling away? Feel your seat belt. That was him doing the opposite.",
#:   "It's no good telling me to keep my distance, I drive a float at fifteen, everything goes round me. So did this lad on his trials bike. Up along the side, a cheery toot. Then he's tucked in so near that my front crates are looking over his shoulder, and up goes his back wheel in the air. I've two hundred pints in the road.",
#:   "Fault analysis. The ego's following distance was legal right up to frame 300. At 300 the follower-turned-leader, a minivan which had travelled past us in lane one, took that distance for itself by coming into ours. At 322 it began to give up its own momentum at seven metres per second squared. The ego had been robbed of its margin before it needed it.",
#:   "The cyclist who filmed it was being passed by both. First in his picture is the doctor's little Fiat, in the near lane. Next, in the far lane, a saloon, faster; it goes by the Fiat, it's across the Fiat's bows before its own tail is properly past, and then you can hear it: the two of them, tyres and tyres, the saloon's first and the Fiat's straight afterwards.",
#:   "All I can say is that I was sat in the back doing my nails. There was a motor going past on our outside. I looked up 'cause we sort of flinched left, 'cause it had come in on top of us. Then I'd got nail varnish up the window, we'd stopped that hard, and the motor what had gone past was right there with its nose on the floor.",
#:   "Some men bow before a lady; this one's car did. He had hastened to get before her, by way of the second lane; he had slipped in so near that the hem of her number plate must have brushed him; and only then did his machine go down on its front springs, long and low, so that hers had nothing left to do but curtsy or crash.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["overtake", "cut-in", "brake"]
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
#: low = 1.0
#: high = 6.0
#: unit = "m"
#: meaning = "how far ahead of the ego it is when it moves over"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.6
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_SPEED = Range(11.5, 15)
param OPT_ADV_AHEAD = Range(1, 6)
param OPT_BRAKE = Range(0.6, 1)

behavior AdvBehavior():
    do DrivePath(advLane, globalParameters.OPT_ADV_SPEED) until headway(egoRoute, ego, self) > globalParameters.OPT_ADV_AHEAD
    do DrivePath(egoRoute, 8) until abs(offsetFrom(egoRoute, self)) < 1
    do BrakeOnPath(egoRoute, globalParameters.OPT_BRAKE) until self.pose[3] < 2
    do DrivePath(egoRoute, 7)
