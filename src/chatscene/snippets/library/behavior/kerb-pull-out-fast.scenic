#: description = "The parked car shoots out from the kerb and speeds off in the ego's lane."
#: rephrasings = [
#:   "The parked car launches itself out of its space and tears away.",
#:   "Vehicle 2 accelerated rapidly from the curb into the lane of vehicle 1.",
#:   "Parked veh, full throttle, into our lane and gone.",
#:   "The target departs from the parking strip with maximum acceleration in front of the VUT.",
#:   "He was parked and suddenly starts like in a race.",
#:   "A getaway car leaps from the roadside with squealing tyres.",
#:   "The courier kicks his motorbike off the stand and rockets out.",
#:   "From standing at the side, the taxi bursts into our lane and bolts.",
#:   "Some boy racer shot out from where he was parked and tore off down the road ahead of me.",
#:   "Unit 2 left the curb at a high rate of acceleration and continued ahead in Unit 1's lane.",
#:   "Parked MC launches out, full gas, gone down our lane.",
#:   "The parked target departs with strong acceleration into the lane of the test vehicle and continues at increasing speed.",
#:   "Police car stands at the side, then suddenly out and very quick away.",
#:   "Parked actor: hard launch into our lane, keeps pulling away from us.",
#:   "It had seemed asleep by the pavement until it leapt out with squealing tyres and raced away before him.",
#:   "Patrol car's coming off the side like a rocket, let him go, he's already away up the road.",
#:   "car parked on the side just launched out and sped off in front of me like fast n furious",
#:   "A parked sports car burst into the traffic lane and roared off down the street.",
#:   "From a state of rest at the roadside he flung his car into the lane and was away down it at a gallop.",
#:   "Parked bike suddenly came out full throttle and just flew ahead in my lane only.",
#:   "One minute he's parked, next minute he's out and halfway to Brighton with his tyres smoking.",
#:   "Rapid departure of parked vehicle into own lane with continuing acceleration away",
#:   "GETAWAY DRIVER? Parked car BLASTS OFF into my lane",
#:   "The parked motorbike catapults out and streaks off ahead.",
#:   "Ambulance off the kerb and legging it up the road ahead, over.",
#:   "Please have a parked hatchback hurl itself into our lane and scorch away.",
#:   "Parked moto, bam, in our lane, foot down, a dot in the distance.",
#:   "That car was sleeping by the path and then it went ZOOM away!",
#:   "Kerbside saloon peels out ahead of Vehicle 1, gaining speed throughout.",
#:   "I'd scarcely noticed the Mustang in its bay when it flung itself into my lane with smoking rear wheels and grew smaller by the second.",
#:   "The fire engine had been stationary by the pavement; on the alarm it was driven smartly into the lane ahead and gathered speed like nobody's business.",
#:   "Cómo se dice, the guy with the motorbike exits from his parking like a bullet, enters my lane and escapes with all the gas.",
#:   "Vehicle at rest in parking strip shall, upon trigger, enter the test lane under maximum drive torque and continue accelerating, thereby opening the distance to the VUT.",
#:   "\"It was parked as good as gold,\" said the lollipop lady, \"and next thing it'd burst out before the blue car and was haring off towards the bridge.\"",
#:   "Was he late for his own wedding, the chap in the parked Jag, that he had to explode out of his space and then hurtle up the road before us?",
#:   "Right, what did we learn from that? You were coming up to a row of parked cars, and one had its wheels turned and exhaust puffing. Out it popped into your lane, hard on the gas, and by the time you'd reacted it was well up the street and still getting faster.",
#:   "The defendant's vehicle stood by the kerb with its engine idling. On seeing two officers emerge from the bank he took it out, with violent acceleration, into the lane in which my client was approaching, and made off in the same direction at ever greater pace.",
#:   "I ride a bicycle to work along Station Road, and I've never seen a thing like it. A biker who'd been sitting there fiddling with his phone suddenly wound it right up, leapt off the kerb into the lane ahead of a robotaxi, and was doing sixty by the chip shop.",
#:   "Bug 784: planner over-brakes when a parked car leaves its slot at very high acceleration. The actor enters our lane at a small gap but immediately outruns us, velocity rising all the time, so a mild lift-off would have been enough. Need a regression scene with this launch.",
#:   "My late husband would have called it showing off. A sporty little car, which had been standing quietly outside the bank, darted out into the lane we were in, and then the young man stepped on it, and with a terrible noise it went racing away down the avenue.",
#:   "Parked Porsche: out ahead of us, gone up the road, tyres howling.",
#:   "off the kerb into my lane like a bullet and just kept getting smaller",
#:   "Motorbike leaves parking bay, our lane, opening up, distance growing fast.",
#:   "What had been a parking space with a coupé in it was now a cloud of rubber, and the coupé was a noise some way up our lane.",
#:   "Configure the kerbside vehicle for a violent getaway: entry into the ego's lane close ahead, then throttle held open so that it draws off from the ego.",
#:   "I have braked for nothing in the end, because the parked scooter which jumped before me in the lane was already flying away like from the police.",
#:   "Unit 2, which had been legally parked, emerged into the lane in front of Unit 1 under heavy throttle and was a block distant when Unit 1 halted.",
#:   "Give those parked ones plenty of room, since now and then one does that: whoosh, into the lane before you, and hammering off up it like a lunatic.",
#:   "His kerbside wait over, the getaway man put the saloon into the lane ahead of the milk float and let her have every horse she'd got.",
#:   "The thing at the side of the road was a motorcycle, and the lump on it was a lad, asleep for all I knew. Then the lump sat up. There was a bang from the exhaust, something crossed in front of my headlight into the lane, and a second later there was a tail lamp dwindling towards the reservoir.",
#:   "It's the opposite of what my braking assistant is made for. It saw a parked hatchback come in before us at two car lengths and it shouted at me and it braked. By then the hatchback's driver had his foot so deep in that we were looking at fifty metres of empty lane, and then a hundred.",
#:   "I was reading a story to the little ones in the front window. There's always a line of cars at our pavement. One of them, a red one, gave a sort of howl and flung itself out into the lane in front of the robot taxi, and off it went up the hill, faster all the time, until we couldn't hear it.",
#:   "Neither the claimant nor her passenger was able to note the registration, for this reason: the vehicle was parked bumper to bumper when they approached, and from the moment it burst into their lane it was drawing away from them. She believes she glimpsed an \"S\" and some smoke.",
#:   "Grey cat, it was, under the front wheel, and I thought, she'll be all right, that car's been parked there for a week. Next thing she's up a tree, the car is in our lane with its back end squirming, and it's putting the lane behind it like a Grand Prix start. We never even had to slow down much.",
#:   "In this recording, pay attention to the relative speed. At first it's strongly negative, since the parked pickup has come into our lane with next to no speed of its own. Within a second it's zero. From there it only climbs, as the pickup goes on gaining pace up the lane and leaves the subject vehicle standing.",
#:   "There was a young fellow courting my granddaughter, and he'd sit outside our gate in his little sports car. He had words with her on Sunday. He was out from the kerb and into the lane in front of the vicar before the vicar could blink, and he went up that lane like the clappers, changing up all the way.",
#:   "Two blokes came out of the jeweller's and got in the back, and I thought, hello. I'd a bus full, so I wasn't looking to be a hero. The Beemer they'd got into came off the parking strip right under my nose and belted away along my lane, and I'd have needed wings to keep up with it.",
#:   "Parking sensors, my foot. What the parked crossover needed was a leash. It was off that kerb and into the bit of lane we were about to use with its front tyres smoking. But to be fair there wasn't time to be cross, seeing how it bolted; we never saw it again until the roundabout, and that's a mile.",
#:   "I am delivering post on a bicycle since fifteen years. In Park Street stands always a Mercedes at the side. Today comes a delivery car along and at this moment the Mercedes springs out, directly ahead of it in its lane, and then goes off with such a howling of the motor that the windows trembled.",
#:   "For the closing shot I'd like the biker to have been propped against his machine by the pavement. As our hero's car draws near he swings a leg over and is gone: one flick into the lane ahead of her bonnet, front wheel light, and then nothing but a shrinking black shape on the road before her.",
#:   "Kerbside Mustang: off the blocks, into our lane, distant speck.",
#:   "bike was PARKED. then it was in my lane. then it was gone lol",
#:   "Empty space at kerb, smoking tyres, hatchback vanishing ahead of us.",
#:   "I never had to follow the sports car that burst out of the parking bay before me, for by the time I'd braked it was over the brow.",
#:   "What had been a parked saloon was now two red dots getting smaller in the middle of our lane, and its wheelspin was still settling on my windscreen.",
#:   "He didn't ease out, he fired: from the pavement to our lane in one movement, tail squirming, and away up the road with the needle going round.",
#:   "The stationary target at the kerb shall, on the ego's approach, take to the ego's lane under full throttle and draw away from it along that lane.",
#:   "Watch for the exhaust on the parked ones; that coupé puffed once, and see, it's been flung into your lane and it's half a street away from you already.",
#:   "Have the motorbike that's waiting beside the pavement leap into our path and leave us standing, so that for an instant we brake and after that there's nothing to brake for.",
#:   "There's a black crescent on the road outside the bank. It begins at the kerb, curls round into the lane in which I was driving, and goes on for thirty feet dead straight in the direction I was going. It was made by the rear wheels of a parked BMW. I made the other mark, a shorter one, behind it; he was off the bridge by then.",
#:   "My sister had bent down for the sat nav lead. She came up again and asked me why we'd braked. In the time she was down, I said, that gap there by the florist had had a car in it, the car had come out under our nose like a cork, and what you can hear now is its third gear. We couldn't see it any longer.",
#:   "The engine of the parked scooter had been popping to itself. As we drew near the popping ran together into a buzz, and the buzz was in front of us, in the lane, low over its bars; then one heard it as one hears a wasp that has found the window open. Mr Harker took his foot from the brake. \"Where to, in such a hurry?\" he said to the empty street.",
#:   "A normal pull-out closes the gap and keeps it closed. In this one, the gap to the vehicle from the kerb is 4 m at the moment it has got itself into our lane, and our brake comes in; then 9, then 20, then 45 m, since it's still at full pedal and we're at fifty. Fail any planner that goes on braking after the second figure.",
#:   "First the good news: he's out of your way. The bad news is what he did for it. He was sitting at the kerb with his lights off, you agree? You'd have had time to pass. Instead he had himself in our lane before your foot could get to the pedal, and he's now at the far end of it doing seventy. Shake your hands out. Carry on.",
#:   "The two suspects ran out of the jeweller's and got in the grey Audi at the kerb. I was in lane one with the school run. I saw the Audi's nose rear up and the whole thing jump in my way, and the kids screamed; but it went from us, you understand, it was gone up my lane so fast that I never even bumped it.",
#:   "Sweeping leaves isn't much of a job, but you see life. There was a lad on a big motorcycle by my barrow, helmet on, waiting on nothing. A post van comes along. Bang, he's off the kerb and into the road just in front of that van, and all my leaves with him. The van's nose goes down. It needn't have, he'd got to the roundabout before it came up again.",
#:   "You ask for the evidence of acceleration. There is the gravel that lies on the claimant's bonnet, thrown there from the kerb. There's the parking ticket, found forty metres up the claimant's lane, having left the defendant's windscreen. And there's the speed camera at the end of that same lane, which has his pickup at 91, nine seconds after he is known to have been parked.",
#:   "Amma had told me to learn from how people take out the car. See signal, see mirror, come slowly. That day the boy in the red Swift at roadside did none. We were reaching him only. Dhoom, he is there in front of our Alto, I am pressing brake with both legs. Dhoom again, and he's not in front, he's a small red thing far ahead. Amma said, not like that.",
#:   "Please don't tell me he was making way for us. If you make way you stay put. The taxi that had been dozing at the kerb was catapulted into the lane when we'd have been by it in two seconds, so that the coffee went all over the presenter, and then, far from holding us up, it was off up the lane ahead like a scalded cat.",
#:   "Bang in front of the hearse, of all things. It was parked outside the Co-op, a little purple Corsa with a big pipe. We came by at our twenty. Out into our lane it goes with its tyres yelping, so I'd to brake with the deceased aboard, and before the flowers had finished sliding it was past the war memorial, past the school, and out of earshot.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["advKerb", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "accelerate"]
#: position = "kerb"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 8.0
#: high = 26.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.75
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_DISTANCE = Range(8, 26)
param OPT_THROTTLE = Range(0.75, 1)

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3) for 0.3 seconds
    do ThrottleOnPath(ownLane(egoRoute), globalParameters.OPT_THROTTLE, 0, 12)
