#: description = "The car ahead bucks and stutters with a failing engine and breaks down in the lane."
#: rephrasings = [
#:   "The old banger in front of us coughs, lurches, coughs again and dies right there.",
#:   "Vehicle 1 exhibited intermittent loss of power, surged several times and became disabled in the roadway.",
#:   "Lead veh engine trouble: jerky throttle, loses drive, dead in lane.",
#:   "The target shows oscillating propulsion followed by a stall in front of the VUT.",
#:   "The motor of the truck ahead is broken, it shakes forward and back and then it remains standing.",
#:   "The bus before us splutters along in fits and finally conks out.",
#:   "A motorbike ahead misfires, hops forward, misfires and gives up the ghost.",
#:   "The driver we follow pumps the gas, the engine catches, fades, and the whole thing is stranded.",
#:   "The old banger in front started coughing and kangarooing, then conked out right there in the lane.",
#:   "The lead vehicle experienced engine trouble, proceeded in jerks and became disabled in the roadway.",
#:   "Lead misfiring, jerky, loses power, dead in lane.",
#:   "The lead target simulates a powertrain failure: surging motion followed by immobilisation in the lane.",
#:   "The car in front has motor problem, jumps jumps and then is broken in the lane.",
#:   "Lead vehicle dies on us: longitudinal surging, then stalls and never restarts.",
#:   "It hiccuped, shuddered, caught again, and then with a last cough gave up the ghost in front of her.",
#:   "Breakdown ahead, he's spluttering along, engine's packing up, and he's going to die in your lane.",
#:   "the car ahead was doing that chug chug chug thing and then it just died",
#:   "An elderly van juddered along on a failing engine before giving up the ghost in the traffic lane.",
#:   "The vehicle in front moved by fits and starts, its motor failing, until it could move no more?",
#:   "Front bus engine was giving trouble, jerking jerking, and finally it went off in the middle of the lane.",
#:   "Hers is spluttering away ahead of me, lurch, lurch, cough, and that's it, kaput.",
#:   "Progressive propulsion failure of lead vehicle ending in disabled vehicle in lane.",
#:   "ENGINE DIES LIVE ON DASHCAM, CAR AHEAD JERKS TO A HALT",
#:   "The truck ahead sputtered, hiccuped and expired.",
#:   "Bike ahead hiccups, surges, hiccups, and packs up in the lane.",
#:   "Lead: alternating thrust and sag, then permanent immobilisation.",
#:   "Our leader's engine fails by instalments until the van's stranded.",
#:   "The car in front went jerk, jerk, jerk and then it was broken.",
#:   "Is that coach in front bunny-hopping itself to death?",
#:   "I want the pickup ahead of the ego to run roughly, jumping forward and falling back by turns, until its motor quits for good in the lane.",
#:   "Water in the petrol, they said: the saloon I was behind lurched along in spasms for fifty yards and then refused to go another inch.",
#:   "Motor from the front lorry is sick, it pulls, it does not pull, it pulls a little, and finish, he stays dead in our lane.",
#:   "V2, immediately ahead of V1, alternately gained and lost speed owing to a fuel fault, and eventually ceased to move in the traffic lane.",
#:   "Ambulance in front has lost power, got some back, lost it again, and it's a total failure now, they're stuck in lane one.",
#:   "That's no way to treat a clutch, is it, the bus ahead of us is pitching back and forth, and now the engine's had it.",
#:   "She had been following the baker's van for a mile when it started to choke. It would gasp, rush on a few yards, gasp and sag again, each rush a little shorter than the one before, until in the end it merely stood in her path, ticking.",
#:   "The lead truck exhibits a degrading drivetrain. In software this means: throttle falls away, recovers for a moment, falls away, recovers for a shorter moment, and then never recovers, so the truck comes to rest as an obstacle in the lane of the AV.",
#:   "Mate of mine had put diesel in his petrol Mondeo and I was the mug driving behind it. Bang, jolt forward, nothing, jolt forward, nothing at all. He conked it in the middle of the lane with me on his bumper and that was our day done.",
#:   "I thought at first he was teasing me, sir, letting the fire engine drop back and spurt and drop back. But there was black smoke puffing out with each spurt, and the last puff was the last of it altogether; she lay there lifeless in front of my vehicle.",
#:   "Motorbike trouble on the A9: rider's been coaxing it along ahead of us, it catches for a sec and leaps, then cuts out, catches and leaps a bit less, cuts out, and he's just had to give up becuase it won't run anymore. Standing in the live lane.",
#:   "Coach ahead jerks, gasps, jerks, and leaves us stuck behind it.",
#:   "Leading scooter sputters along in hops until its motor packs up.",
#:   "The van in front lollops, chokes and expires in lane.",
#:   "Have the car ahead behave like one with a clogged fuel filter, sagging, jerking forward, sagging again, until it's a breakdown in the ego's lane.",
#:   "He is before me, his motor makes prrt, prrt, he jumps a little, he falls asleep, he jumps less, and then the camion is dead on my lane.",
#:   "You get to know the signs in a lead vehicle: the head of the driver nodding back and forth as it hunts, then hazards, then nothing.",
#:   "The fire engine we were to follow ran on fewer cylinders at each lamp post, heaving itself forward by spasms, and at the chemist's it ran on none.",
#:   "Oh dear, the lady in front's got no petrol, hear it, hop, cough, hop, cough, and there it goes, stone dead where we need to be.",
#:   "Disabled vehicle, lane two, grey pickup; it was ahead of us bucking like a mule for a hundred yards and then the engine quit altogether.",
#:   "I'd borrowed a trailer and was taking it easy behind a camper van. Its exhaust began to pop. With every pop the van's tail squatted and it made a little leap away from me; in between it fell back on me as though it'd been let go. Three leaps, each smaller, and after the third it never moved again.",
#:   "The insured's passenger describes the vehicle in front as \"rocking\". It is to be understood that its propulsion came and went: the distance opened by a few metres, closed, opened by less, closed, and thereafter closed for good, the vehicle having become immobile in the traffic lane with a seized pump. There was no braking to speak of.",
#:   "My first bike was a two-stroke with a bad carb, so I felt for him, the kid on the scooter in front of us. You could hear it: waaah, nothing, waaah, nothing. With each waaah he'd shoot off a bit, with each nothing he came back to our bumper. The last nothing was final and he hung his head.",
#:   "There was smoke first, and she shut the vents. Then the ambulance began to behave oddly ahead of her, now hanging back with its bonnet drooping, now pitching on with a snort. The snorts got feebler. By the church it hadn't another in it and stood, still flashing, in the only lane there was, and would go no further.",
#:   "Log comment: the leading truck's reported acceleration flips sign four times in six seconds with its brake lamps dark. My first idea was sensor noise. It wasn't, it's an engine failing: minus, plus, minus, a weaker plus, then a longer minus that ends in standstill. Truck remains in lane, hazards on. Subject vehicle queued behind it.",
#:   "Who goes out with the fuel light on for three days? My neighbour does, and on Sunday I'd the pleasure of driving behind him. On the hill the Astra started to splutter and buck, you could see daylight under the tyres nearly. He rocked in his seat to help it. It expired outside the bakery, bang in front of me.",
#:   "The bus was my lead vehicle for most of the route. Passengers later said that \"it was hopping like a kangaroo\", and that they'd all held on to the poles; from behind one saw the same, a stagger, a shove, another stagger, a lesser shove. I stopped when it couldn't stagger any more. It had to be towed out of my lane.",
#:   "Good evening, I want to tell my experience with one tempo traveller. He was going in front of me only. Suddenly it started giving jerks, one time pulling fast, one time becoming loose, again pulling, again loose. I kept distance, thank God. After some time full engine was seized and it was standing in middle of my lane like a cow.",
#:   "You could tell where the thing had finally died by the puddle of oil in the middle of the lane, and where it had begun to die by the first of the drips. Between the two lay eighty metres, along which the lorry ahead of our car had surged and sagged, surged and sagged, to the sound of its own backfiring.",
#:   "the thing with driving behind a classic car rally is statistically one of them gives out. ours was a beautiful MG right in front. it went cough LURCH cough lurch coughhh. then silence. then two gents in flat caps got out in the middle of our lane and opened the bonnet like theyd rehearsed it",
#:   "My instructor has a rule about vehicles that nod: keep away. Here was one, a police car of all things, nodding its nose up and down up ahead as its power came in and dropped out. I kept well away. A minute after, its power dropped out for the last time, and it was a police car-shaped plug in our lane.",
#:   "Front moped: cough, hop, cough, hop, silence in our lane.",
#:   "Lurch by lurch the coach ahead ran out of engine.",
#:   "Truck before us gasps its way forward, then gives up entirely.",
#:   "The distance to the van ahead shrank, grew, shrank, grew a little less, and then shrank for good, with black smoke over all of it.",
#:   "I'd like the lead motorbike's engine to cut out, catch, cut out, catch weakly, and cut out for ever, leaving it in our lane.",
#:   "Nod, nod, nod went the head of the driver in front, in time with his misfiring engine, and then it and the car were still.",
#:   "V2, ahead in the same lane, exhibited alternating loss and recovery of drive over a short distance and then came to rest, its engine dead.",
#:   "Is it the petrol or the plugs that makes a fire engine rock like that before it dies on you, plumb in the lane ahead?",
#:   "He kangaroo'd along in front of my push bike, poor chap, each bound shorter than the last, and where the last one ended, there he sat.",
#:   "I can play you the whole accident on the bagpipes. A drone that sags. A squawk as it picks up. A longer sag. A feebler squawk. Then that horrid wheeze of the bag emptying. Those were the last fifty yards of the camper in front of us, and at the wheeze it was standing in the lane and so were we.",
#:   "Sixteen times my follow control braked and let go again, I counted the clicks, because what it was following wouldn't make up its mind. The bus's power came and its power went. When it came, people's heads flew back, and when it went, they flew forward. In the end they stayed forward. It didn't budge from our lane all evening.",
#:   "Caller is behind a stricken ambulance on the A40, no patient on board. It had been hiccuping for some way in front of her, she says, slackening off and then shooting on a bit, so she'd dropped back, luckily. It's now without any engine, it isn't on the hard shoulder, it's in lane one, and so's she.",
#:   "Read the exhaust, not the brake lights. There weren't any brake lights, see? A puff: his engine's caught, he's jumped on a yard. No puff: he's sagging back at you. Puff, a smaller one. No puff. No puff. And that's your bin lorry broken down in front of you with the handbrake on. Mirror, and let's find a way round.",
#:   "She'd borrowed her father's Morris and filled it with what proved to be paraffin. I know because I towed it. Before I could tow it I had to follow it, and it was like following a rabbit with the hiccups: hop and droop, hop and droop, till by the water tower there was no hop left, only droop, and a smell.",
#:   "The injector, emulated in software, fails in five phases of which the following vehicle sees only the consequences: a slight loss of speed in the vehicle it follows, a recovery, another slight loss, a recovery of about half the duration, and lastly a loss that ends in standstill. There's no lateral movement, so the lane stays obstructed.",
#:   "In front goes a motorino with two nuns. First it does brrr, then nothing, then brrr and they hold their veils, then nothing, then br. After the br it doesn't do anything. They remain sitting in the middle of my lane, on a motorino that is dead, and they look up at the sky for help.",
#:   "What I took for bad temper was bad diesel. The lorry in front kept falling back upon me and bolting and falling back, as if to provoke. I flashed him. The next bolt was hardly a bolt. When he'd fallen back for the third time he never left again; the driver climbed down, in the lane, and spread his hands.",
#:   "Our following distance setting was two seconds, which turned into one, into three, into one, into two, into none. All of that while we were driving at a constant speed, or trying to. The squad car in front had water in its tank, the sergeant confessed. He'd felt it choke twice and pick up twice, and then it had just quit.",
#:   "\"It's dying,\" said Ned. \"It's only resting,\" said I, for the tractor unit we were trailing had found its voice again and heaved forward. \"Now it's dying.\" \"No, look.\" It heaved, if one could call it that. Then the twitching ceased; and Ned, who was nine, removed his cap to the thing that was standing in our lane.",
#:   "Spilt petrol, a hot day, and a row of small wet patches on the road, close together and closer still towards the end, which is where the motorbike was. At each patch its engine had flooded and it had nearly stalled and then leapt on with a bang, in front of my bumper. At the final one it had stalled outright.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: vehicle failure; own code"
#: [slots]
#: actions = ["accelerate", "stop"]
#: position = "ahead"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.5
#: high = 0.8
#: unit = "1"
#: meaning = "how far the pedal is pressed"
#: [[parameters]]
#: name = "OPT_THROTTLE_TIME"
#: low = 0.6
#: high = 1.2
#: unit = "s"
#: meaning = "for how long it presses the pedal"

param OPT_ADV_DISTANCE = Range(0, 30)
param OPT_THROTTLE = Range(0.5, 0.8)
param OPT_THROTTLE_TIME = Range(0.6, 1.2)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, 0.15) for 1.5 seconds
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE) for globalParameters.OPT_THROTTLE_TIME seconds
    do BrakeOnPath(advTrajectory, 0.15) for 1.5 seconds
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE) for 0.6 * globalParameters.OPT_THROTTLE_TIME seconds
    do BrakeOnPath(advTrajectory, 0.5)
