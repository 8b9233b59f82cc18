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
