#: description = "The car cuts in front of the ego, jabs the brakes and then speeds away."
#: rephrasings = [
#:   "Some hothead swerves in, brake-checks us and roars off.",
#:   "Vehicle 2 changed lanes directly ahead, applied its brakes and then accelerated out of the area.",
#:   "Cut-in, brake stab, departs at speed.",
#:   "The target cuts in before the VUT, performs one brake pulse and accelerates away.",
#:   "He jumps before us, makes brake for punishing, then goes quick away.",
#:   "A biker flicks across, grabs a handful of front brake and blasts off.",
#:   "The van barges over, lights up its tail and bolts.",
#:   "An angry lorry driver takes our lane, checks us sharply and presses on.",
#:   "Prat swerved in ahead of me, dabbed his brakes for a laugh and then tore off.",
#:   "The suspect vehicle merged in front of the complainant, briefly activated its brakes and fled at high speed.",
#:   "Cuts in, stab of brake, then full throttle & away.",
#:   "The target enters the VUT's lane, applies a short brake pulse and thereafter accelerates out of range.",
#:   "He goes in my lane before me, brakes short time, and after that runs away with much gas.",
#:   "Merge + 1 s brake tap + bolt: side vehicle takes our lane, pecks at the brake, then sprints off.",
#:   "He slipped in front of her, flashed his brake lights in her eyes for an instant, and was away before she could catch her breath.",
#:   "Van's come in on you, he'll give it a quick prod of the brake and then he'll scarper, so don't rear-end him.",
#:   "guy cut me off, tapped his brakes to be annoying n zoomed away",
#:   "Having barged in front, the driver gave a short stamp on the brake before roaring off, the victim told reporters.",
#:   "First you came in before her, then you touched your brake, and only then did you make off; is that the sequence?",
#:   "He cut into my lane, jammed brake for one second, then ran away full speed.",
#:   "Gets in front, gives me a flash of his brake lights for a lark, and scarpers.",
#:   "Close merge, transient braking and rapid departure of adversary.",
#:   "CUTS IN, BRAKE CHECKS, FLEES",
#:   "The motorcycle knifed in, pecked at its brake and bolted.",
#:   "nips in dabs the anchors clears off at speed",
#:   "Ambulance squeezes in ahead of us, brakes briefly, hurtles onward.",
#:   "Tanker moved over on me, braked once, then powered away.",
#:   "ROAD RAGE: he dives in, brake-checks me and guns it",
#:   "Lane intrusion in front, single brake impulse, brisk departure of target.",
#:   "Simulate a pickup that forces itself in front of the AV, gives one sharp squeeze on the brake and straight afterwards hares off down the road.",
#:   "The coach came over into our lane from the side, its brake lights blinked on for about a second, and then it gathered way and left us standing.",
#:   "What my husband calls a punishment brake: he pushed in before us, stood on the pedal a moment and was gone in a cloud of diesel.",
#:   "The motorbike is entering before the test vehicle, it makes a little brake, only to frighten, and after it escapes with big acceleration.",
#:   "V2 merged immediately ahead of V1, decelerated hard for less than one second and left the scene under strong acceleration, its plate unreadable on the video.",
#:   "By the time I'd finished swearing he was a dot on the horizon, having first carved me up and then jabbed his brake at me.",
#:   "The silver estate was next to me, and I think he objected to my speed. He swung over so that his rear bumper was just ahead of mine, hit the brakes hard enough for my seat belt to lock, and then simply put his foot flat and left.",
#:   "Insured was proceeding normally when a third-party minibus moved across into the insured's lane with little room. The third party then braked for no apparent reason, momentarily, and thereupon accelerated away. The insured avoided a collision and noted part of the registration number.",
#:   "Watch what the biker does at 0:42. He filters across to our side of the line just in front of the bonnet, taps the rear brake so the light flares, we nose-dive, and before the horn even sounds he has opened it up and vanished.",
#:   "The behaviour has three phases. First the adjacent truck takes the lane of the vehicle under test at short range; next it applies its service brake for a short time, without standing still; finally it releases and picks up speed until out of the relevant area.",
#:   "I say to you, in my country also we have such drivers. This taxi comes from the side lane in front of my nose, he brakes so I must brake, like a lesson for me, and then he presses everything and flies away.",
#:   "Barged in, flared his stop lamps, legged it.",
#:   "Lorry elbows into our lane, pecks the brake, storms off.",
#:   "Nosed ahead of us, anchored up for an instant, then vamoosed.",
#:   "The fire engine came over the line ahead of us, checked itself with a short hiss of air, and then pounded off towards the smoke.",
#:   "Why take my lane with a foot to spare, hit the pedal for half a second, and then disappear like a rocket, if not out of spite?",
#:   "Adversary inserts from the adjacent lane ahead of the subject vehicle, shows brake lamps for under one second, then exits at maximum acceleration.",
#:   "My complaint is against the biker who pushed into my front, made one sudden braking like warning to me, and then ran away at full speed.",
#:   "Have a van take our lane out of the blue at close range, stab its brakes the once and then hammer off down the road.",
#:   "bit of red light in my face from the taxi thatd just shoved in front of me and then he was gone full throttle",
#:   "I'd flashed him, which I shouldn't have done. The next thing, his boot had swung across in front of me and was rushing at my windscreen, tail lamps blazing, and my coffee went over the dash. By the time I had found a tissue he'd stormed off and was just a speck at the top of the hill.",
#:   "The insured recalls a tanker travelling abreast of her in the next lane. It encroached on her lane until it was wholly ahead of her, decelerated sharply though only momentarily, and then drew off under full power. Her dog was thrown against the seat. No contact was made and the tanker was not traced.",
#:   "Did you see that? He comes over on us with no room, gives us a kick of the brakes so we all nod forward like chickens, and bang, off he goes. That's what we call a brake check, and the right answer is exactly what you did: ease off, don't hoot, let him run.",
#:   "The log has three events within four seconds. At t0 the object in the right lane appears in ours with a gap of 6 m; at t1 the gap has sunk to 3 m and its stop lamps are lit; at t2 they are out and the gap is growing by eight metres every second.",
#:   "Some music was on, so I didn't hear the bike come up level. It slotted in ahead of my bumper as neat as a letter in a box, and as it did the rider squeezed the lever, just to show me. Then the front wheel went light and he was away, and I found I'd been holding my breath.",
#:   "We could still smell his brakes and his exhaust when he was long gone. It was a police van with no blue lights on, and it had come across into our lane off the right-hand side, dug its nose in for a moment as though the driver had seen something, and thundered away toward the docks.",
#:   "Bus man, thirty years, never a scratch. This pickup squirts across from lane two, lands under my windscreen, and on come his reds. I've got forty standing passengers, mind. Before I've even got my foot properly down the reds go off, he's dropped a gear and he's heading for the horizon.",
#:   "In our country a small lesson is given so. The driver of the coach went into my lane, hard before my nose; he stepped on the brake, but not long, only until I was frightened; and thereafter he gave everything and was after ten seconds not to be seen any more.",
#:   "He wanted to be quit of them, that was plain, but he wanted first to be unpleasant. So the long grey car slanted in before their radiator and dropped its weight on its front wheels, and their own tyres shrieked. It gave a kind of leap then, and the dust of its going hid the road.",
#:   "The gap opened again as fast as it had closed, which is what saved us. Our following distance had been swallowed up when the ambulance moved over into our lane, and what little was left went when it braked, one quick dab. After that it accelerated so strongly that within seconds we had the lane to ourselves.",
#:   "Tonight's clip comes from Leeds. Watch the moped in the bus lane: it jinks over in front of the camera car, its tail light winks bright, you hear the tyres chirp and a word I can't broadcast. And look, he's wound it on and buzzed off before the poor woman has stopped shaking.",
#:   "Into our gap, red flash, smoke, and off like a bullet.",
#:   "Barges in, gives us one stab of pedal, then vanishes uphill.",
#:   "Lane pinched, brake lamps blinked once, exhaust howled, lane empty.",
#:   "The lorry's flank became the lorry's rear, its tail lit for a second, and with a belch of black it thundered on out of our reach.",
#:   "He has shown me first his indicator not, then his stop lamps in my face, then only a cloud; all this inside of four seconds.",
#:   "Range 30, range 6, range 3, range 60: side car joins us, dips its nose for an instant, leaves under full power.",
#:   "First my lane went, then my gap, then my coffee; and the pickup that took all three was itself gone over the brow with its engine screaming.",
#:   "If the coach was going to bolt like that, why first shove itself in under my windscreen and give me a whole second of brake lights?",
#:   "Let the motorbike snatch the strip of road in front of the ego, punish it with one squeeze of brake, and tear off at full throttle.",
#:   "The belt did its job before I had worked out what it was for. When I had, it was over: the stop lamps that had flared up a yard before us, on a car that a moment earlier was in the next lane, had gone out, and the car itself was a whine in the distance.",
#:   "You've heard of hit and run; this was brake and run. Some genius in a tanker decides that my bit of motorway is his, slots in without a by-your-leave and dips his front like a curtsey. I've got smoke off all ten tyres. He, meanwhile, changes down, and I get to watch him make for Scotland.",
#:   "Two jolts, said the conductor, and then a long pull. The first jolt was the driver's when an ambulance came across from the outer lane into ours. The second was its doing, for its back wheels all but locked. The long pull wasn't ours at all; it was the ambulance, getting up speed and dwindling down the avenue.",
#:   "I was left alone in my lane, hazards flashing, hardly doing fifteen, and nobody who came upon me then could've guessed why. There was no car in front. There'd been one all right. It had dived in off the left, clamped its anchors on long enough to make me stamp on mine, and streaked away.",
#:   "Distance keeping is fully restored at t = 9 s without any contribution of ours, as the truck departs faster than we drive. What matters lies before. At t = 3 s it enters our lane laterally, four metres ahead. At t = 4.5 s it sheds five metres per second in a short pulse, and from t = 5.3 s the throttle reads one hundred.",
#:   "Officer, he wanted me to hit him, I'd swear to that on the book. Why else would you wait till you're level, throw your wagon in front of a woman with three kids aboard and touch the brakes with an empty road ahead? And when I hadn't hit him he put his boot down and you couldn't see him for dust.",
#:   "Read the sparks, lad. Spark one, the rider's foot peg as he heels over into our lane off the right-hand one. Spark two is his brake light, on and off, like a wink, and it fetches our front end down. And spark three's the exhaust popping as he winds it right up. Three sparks and he's history.",
#:   "Papa braked so much that my ice cream went on the glass. It was because the yellow bus wasn't next to us any more, it was in front, and its red eyes were on. I wanted to see the eyes again but they were off already, and the bus roared and ran from us up the big hill.",
#:   "There is a rage which only wants a witness. It steered him out of his own lane into hers, so near that her lamps went out against his boot; it made him touch the pedal, as one raps a child's knuckles; and then, having been seen, it drove his foot to the boards and took him out of her life.",
#:   "Claimant's telematics give a deceleration peak of 0.8 g lasting half a second, with no collision. Dash camera explains: fire vehicle, no siren, moves over from the left lane immediately in front of claimant; its brake lights are lit for eleven frames; thereupon it gathers speed so vigorously that it can no longer be made out at second seven.",
#:   "Down the pub they don't believe me about that Corsa. It nips in off the slip with me doing fifty-six and forty foot of steel on, its arse goes up and its front goes down, and I'm standing on everything. Then, cheeky sod, up comes the front and it's off like its tail's on fire. One tap, that's all he'd wanted to give me.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cut-in", "brake", "accelerate"]
#: leader = false
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -10.0
#: high = 25.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 0.0
#: high = 6.0
#: unit = "m"
#: meaning = "how far its rear is ahead of the ego's front before it moves over"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.6
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_BRAKE_TIME"
#: low = 0.7
#: high = 1.2
#: unit = "s"
#: meaning = "for how long it brakes"

param OPT_ADV_DISTANCE = Range(-10, 25)
param OPT_ADV_AHEAD = Range(0, 6)
param OPT_BRAKE = Range(0.6, 1)
param OPT_BRAKE_TIME = Range(0.7, 1.2)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD + (ego.length + self.length) / 2, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(egoRoute, 7) until abs(offsetFrom(egoRoute, self)) < 1
    do BrakeOnPath(egoRoute, globalParameters.OPT_BRAKE) for globalParameters.OPT_BRAKE_TIME seconds
    do ThrottleOnPath(egoRoute, 1, 0, 11)
