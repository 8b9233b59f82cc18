#: description = "The car goes through the intersection in bursts of throttle and brake."
#: rephrasings = [
#:   "A vehicle crosses the junction with a pace that keeps rising and falling.",
#:   "The adversary accelerates, brakes, and accelerates again on the crossroads.",
#:   "The crossing driver cannot settle on a speed.",
#:   "Jerking forward and checking itself, the car passes before the ego.",
#:   "The other car alternates gas and brake while it crosses.",
#:   "gas, brake, gas, brake, he can't get across in one go",
#:   "Vehicle 2 alternately accelerated and braked while crossing.",
#:   "The target traverses the junction with repeated phases of acceleration and deceleration.",
#:   "He kangarooed through the crossroads, on and off the gas like a learner.",
#:   "Unit 2 passed through the intersection in a jerky manner, alternately speeding up and braking.",
#:   "Moto thru junction: gas, brake, gas, brake.",
#:   "The target vehicle traverses the junction with alternating acceleration and deceleration phases.",
#:   "The car goes in the crossing fast, brakes, fast again, brakes again.",
#:   "Longitudinal sawtooth profile while clearing the box; path itself is straight.",
#:   "It came on in leaps, lunging and checking and lunging again until it was over.",
#:   "Look at him bunny-hopping across the junction, foot down, foot off, you can't read him.",
#:   "he was going thru the intersection like vroom stop vroom stop, made me carsick just watching",
#:   "A motorcyclist went over the crossroads by fits of speed and braking.",
#:   "His progress through the intersection was spasmodic: now pressing on, now checking, now pressing on again.",
#:   "Jerk jerk he is crossing the signal, one second race, one second brake.",
#:   "Somebody teach him what his feet are for: gas, brake, gas, brake, the whole width of the junction.",
#:   "Pulsating longitudinal speed of vehicle throughout the intersection",
#:   "LEARNER? Car HICCUPS its way through the junction",
#:   "The car stutters through the crossing in spurts.",
#:   "On-off, on-off with the throttle all the way over the crossroads.",
#:   "Car crosses box lurching: spurt, check, spurt, check.",
#:   "Biker revs, brakes, revs, brakes till he's through the intersection.",
#:   "Make the hatchback pulse between gas and brake while crossing.",
#:   "The taxi went over the junction nodding like a rocking horse.",
#:   "A pupil with two left feet is crossing ahead of us, and every dab of accelerator is followed by a dab of brake until she's over.",
#:   "Within the intersection the crossing vehicle's longitudinal command shall alternate periodically between positive drive torque and service braking, without its path being altered.",
#:   "hed put on a burst of speed loose his nerve and slow, put on another burst lose it again, thats how the saloon got accross the junction",
#:   "Investigators noted several short acceleration marks and several short skid marks left by V2 within the intersection, one after the other in regular turn.",
#:   "I want a motorbike coming over the crossroads with a surging speed, now twisting the grip, now squeezing the lever, over and over till it's out.",
#:   "Driver is giving race, then pressing brake, then again race, again brake, like this only he has passed the whole crossing in front of me.",
#:   "I could see the passenger's head being thrown back and forward. The little Fiat was coming over the junction from the side, and whoever drove it kept stamping first on one pedal and then on the other, so you couldn't tell when it would be gone.",
#:   "Because the speed of the crossing car rises for a second, falls for half a second and rises again for as long as it is in the junction, a constant-velocity prediction is wrong each time, and the ego must keep its estimate of arrival open.",
#:   "Comment from the cammer: no idea what was up with the bloke on the Yamaha. He comes through the crossroads in hiccups, big handful, grab of brake, big handful, grab of brake, and I'm just sitting there with my foot hovering thinking make your mind up pal.",
#:   "She had never driven the thing before, and it showed. It bounded into the crossing, was reined in, bounded again and was again reined in, and so by leaps and checks it got itself past the bonnet of our waiting car.",
#:   "Claim ref 88-102. The other motorist traversed the crossroads unevenly, pressing the accelerator and the brake in turns a good five times, with the result that our policyholder could not judge whether to wait or to proceed. No constant speed was kept at any moment.",
#:   "Surge, check, surge, check: that coupe's way over the crossroads.",
#:   "Spasms of throttle carry the moped through, each cut off by brakes.",
#:   "Across the junction he came like a rabbit, hop and halt-ish.",
#:   "The saloon passed over the intersection in a string of little sprints, every one of them smothered by the brake before the next began.",
#:   "Across the whole of the junction area, target speed shall follow a periodic profile with drive phases of set length and braking phases half as long.",
#:   "Let a motorbike get over the crossing by pumping, first the grip then the lever then the grip again, never one even speed.",
#:   "The front of that Polo kept rearing up and diving, up and down, all the way from one side of the junction to the other.",
#:   "Why did your policyholder wait? Because the crossing hatchback kept speeding up and slowing down by turns, and nobody could say when it would be out.",
#:   "She presses, she frightens, she brakes, she presses once more, and so passes the lady all the crossing before me, it was like a boat.",
#:   "First its brake lamps were on, then they were off and the tail sank, then they were on again. I counted four such changes before the taxi had left the junction. My foot was doing the same dance over my own pedal, because each time I thought it was off it wasn't, and the other way round.",
#:   "You know those toy cars on a rubber band that you wind up over and over? He was like it, the gent in the Rover. A lunge, and it died, another lunge, and that died as well, and so he lunged and died through the crossroads till he was in Market Street.",
#:   "Unit 2's driver, age sixteen, held a learner's permit. The intersection camera recorded her vehicle accelerating and braking in alternation no fewer than five times between entry and exit. V1's operator, unable to judge the gap, braked and was struck from behind by V3.",
#:   "Every rider has done it on a cold engine. I gave her some, she jumped, I grabbed the lever, she dropped, I gave her some more, jump, grab, all the way through the junction with my visor banging my nose. That car without a driver was being ever so patient about it.",
#:   "It is not the mean speed of the crossing vehicle that matters, which is quite harmless. On top of it sits an oscillation, since the driver alternates between a second of throttle and half a second of brake for as long as the junction lasts, and time-to-conflict is therefore wrong in both directions.",
#:   "The dog was on the back shelf, and it gave the game away. Forward it slid, back it slid, forward, back. Outside the dog's little grey car was crossing our junction by squirts, squirt and stamp, squirt and stamp, with the old lady's chin going up and down in time.",
#:   "I must have started and stopped the description five times, much as he did. He was in the intersection and going quickly; no, he was slowing; no, he was going quickly. And since that is exactly what he did from one kerb to the other, foot on the one and then on the other, let it stand.",
#:   "Please take care with the \"indecisive crosser\" actor. It comes from the cross street and doesn't turn. While it is in the box its speed must rise and sink, rise and sink, with pedal changes about every second, and it must not come to a full stop or run off smoothly at the end of the first pulse.",
#:   "Dad, that car has the hiccups, I said, and he laughed but he had to be careful. It went whoosh and then it nodded, and whoosh and then it nodded, right across where the roads meet. He said the driver can't make up his mind if he wants to go or to brake so he does both.",
#:   "Bengaluru, 9 a.m., signal not working. Swift comes across from the side. He will give accelerator, we will stop, he will press brake, we will start, he will again give accelerator, we will stop. Like this, full junction he has crossed in pieces, and behind me everyone has their hand on the horn.",
#:   "At the briefing they played us the sound alone, and asked what we thought it was. A rasp and a squeak, a rasp and a squeak, six times over. It was a sports bike working its way through the crossroads in front of the shuttle, every opening of the throttle taken back by a snatch at the brake.",
#:   "Crossing Golf can't hold a speed: spurt, nod, spurt, nod, spurt.",
#:   "Rider clears the box in surges, throttle chopped by brake each time.",
#:   "Pulse the crossing car: power, pedal, power, pedal, until it's out.",
#:   "With every press of the gas I counted it gone from the crossroads and with every stab at the brake I counted it back in my way.",
#:   "The brake lamps of the crosser blinked on and off like a lighthouse, and its pace swelled and sank with them from one side of the junction to the other.",
#:   "You could hear the learner's indecision in the intersection: rev, squeal, rev, squeal, four or five of each before he'd left it.",
#:   "From entry to exit of the junction, the target's acceleration signal shall alternate in sign, positive for one period, negative for half of one.",
#:   "He had a new clutch foot, so to say, because he came over the crossing by jumps, with a jab of the brake after every jump.",
#:   "Now it's quick, now it isn't, now it's quick again, I can't tell you when she will be through that junction, so stay where you are.",
#:   "My passengers thought I was making fun of him. I'd roll because he'd braked, then stop because he'd gone for it, then roll because he'd braked, the way two people dodge in a corridor. All this in the eight or so seconds that the taxi needed to get from Pine Street over to the other half of Pine Street.",
#:   "The tyre marks in the intersection look like Morse. A short black pair where the drive wheels scrabbled, a short grey pair where the brakes bit, black, grey, black, grey, eleven in all, on a line from the east crosswalk to the west crosswalk. Vehicle 1 had been in two minds the whole time, says its owner.",
#:   "Water came over the rim of the goldfish bowl which the boy had on his knees, first to the back, then to the front, then to the back again. I saw that through the side window of the Fiesta, as it went past my bumper through the junction. The mother's right foot was hopping between the pedals.",
#:   "What the planner wants to know of a crosser is one number, namely when it'll be gone. With this motorbike the number was 2.1, then 4.0, then 1.8, then 3.5. It wasn't noise. The rider kept opening up and checking himself, over and over, all across the box, while his line stayed as straight as could be.",
#:   "Never had I seen a horse drive a car, but that afternoon at the crossroads I believe I did. It came over from the side with its head flung up, and its head went down, and up it was flung once more. Each fling carried it some yards nearer to the far street, and each ducking robbed it of its courage.",
#:   "I'd the bike on two cylinders instead of three. Open her up, she'd catch and bolt, so I'd snatch at the lever; she would bog, so I would open her up, and she'd bolt. Bolt, snatch, bolt, snatch, all across the junction. There was a robotaxi waiting to see what I'd do, and it waited till I was well clear.",
#:   "Traffic lights out, officer on point duty reports. I waved the grey hatchback over. The driver, an elderly gentleman, proceeded at such a rate that I put my hand up, whereupon he checked; I beckoned, he shot on; hand, check; beckon, shot. He was over in this manner before I understood that he wasn't looking at me at all.",
#:   "Look at her nose, not at her wheels. Nose comes up, that's gas. Nose drops, that's brake. And up, and down, and up again, she's doing it the full width of this junction. If we go on an \"up\" we may meet her on a \"down,\" you see? Handbrake, and a bit of patience until that nose is in the side street.",
#:   "The prosecution speaks of one burst of speed. The film shows five. It likewise shows, after each of them, the saloon's tail lamps aglow and its pace dropping by half. In that fashion, gaining and losing by turns, it traversed the crossing, and my client, who is no clairvoyant, couldn't foresee which of the five she'd meet.",
#:   "Scene wish, no. 14: someone with cramp in the leg. He comes from the crossing street and remains on it. As long as he is inside the junction his speed goes up one second, down half a second, up one second, down half a second; please don't stop him altogether and don't let him change direction.",
#:   "It was like the music when somebody scratches, you know, forward-back, forward-back, only he doesn't go back, he goes more and he goes less. A Vespa with a delivery box. More gas, less, more, less, through all the crossing before our noses, and the pizza in his box is today a calzone, I am sure.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["accelerate", "brake"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.6
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.4
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 1.0
#: high = 2.0
#: unit = "s"
#: meaning = "how long each phase lasts"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_THROTTLE = Range(0.6, 1)
param OPT_BRAKE = Range(0.4, 1)
param OPT_ADV_PERIOD = Range(1, 2)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    while True:
        do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE) for globalParameters.OPT_ADV_PERIOD seconds
        do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) for 0.5 * globalParameters.OPT_ADV_PERIOD seconds
