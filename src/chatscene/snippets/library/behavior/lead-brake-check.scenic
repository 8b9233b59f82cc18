#: description = "The car ahead taps its brakes twice to scare the ego and drives on."
#: rephrasings = [
#:   "The idiot in front brake-checks us, once, then again, and carries on as if nothing happened.",
#:   "Vehicle 2 applied its brakes sharply two times in succession and continued in its lane.",
#:   "Lead car: two short hard brake applications, then proceeds.",
#:   "The target shows two brake pulses and resumes travel ahead of the VUT.",
#:   "The man ahead is touching the brake strongly two times, for anger, then he goes further.",
#:   "A road-raging trucker dabs the brakes twice right under our nose.",
#:   "The motorcyclist before us flashes his brake light with a jolt, does it a second time and rides off.",
#:   "Double jab on the pedal by the driver we follow, meant to teach us distance.",
#:   "The muppet in front dabbed his brakes at me, twice, just to put the wind up me, and drove on.",
#:   "The operator of the lead vehicle tapped the brakes two times in an apparent attempt to intimidate the following driver, then continued.",
#:   "Lead: 2x brake tap, intimidation, continues.",
#:   "The lead target applies two short brake pulses without significant loss of speed and continues.",
#:   "The car in front pushes the brake two times to make me afraid, and goes on.",
#:   "Lead vehicle brake-checks us with two blips; doesn't stop, drives on at speed.",
#:   "He blinked his brake lights at her once, then again, out of pure spite, and rolled on as though nothing had happened.",
#:   "He's just warning you off, giving you a couple of jabs on the brake because you're too near, back off a bit.",
#:   "guy ahead tapped his brakes like two times just to mess w me",
#:   "Lorry driver twice flashed his brakes to frighten the car following him, court told.",
#:   "You touched your brake once, and then again, for no purpose but to alarm the driver at your rear, and drove on?",
#:   "Front car simply tap tap the brake to scare me and then going on as usual.",
#:   "Tap, tap with the brake in front of me, thinks he's teaching me a lesson, then carries on like an angel.",
#:   "Repeated intimidatory brake application by lead vehicle without stopping.",
#:   "GETS BRAKE CHECKED TWICE, STAYS CALM",
#:   "The lead car winked its brakes at us twice and rolled on.",
#:   "Bloke ahead stabs his brakes, stabs them again, carries merrily on.",
#:   "Front van: brake lights, brake lights, just to rattle us, proceeding.",
#:   "two nasty litle dabs from the coach in front then onward",
#:   "Let the lead bike blip its brake twice at us, then continue.",
#:   "Ma, that driver blinked his red lights two times to frighten you!",
#:   "The cab we were following braked for a heartbeat, released, braked for another heartbeat, and went its way, evidently to put the fear of God into us.",
#:   "Two successive intimidation pulses on the service brake are applied by the lead vehicle, about a second apart, whereupon it resumes its speed in front of the VUT.",
#:   "Why is he pecking at that pedal, once, and now a second time? To scare you off his bumper; see, he's rolling along again.",
#:   "He was upset that I was near, so he has given a short brake, then one more short brake, and after he drove normally further.",
#:   "An angry trucker in front of the robotaxi wanted to see it flinch: a touch of the brakes, a pause, another touch, and away he trundled.",
#:   "Without any obstacle in his way, the officer ahead of me hit and let go his brakes, did so a second time, and pursued his journey.",
#:   "My wife can confirm that the road before the SUV was empty. He nevertheless jammed his brakes for an instant, let us recover, and jammed them again, a clear act of bullying as I see it. Then he drove along as placidly as you please.",
#:   "You'll meet this on the motorway, love. Someone in front takes offence, and you get a jab of brake lights and your heart's in your mouth; then a second jab. They're not stopping. They just want you rattled, and afterwards they cruise on in the lane.",
#:   "Analysis of the lead motorcycle's deceleration trace reveals a pair of brief peaks separated by slightly more than one second, with a partial recovery of speed between. As no hazard existed, the intent was presumably to startle the following vehicle. Thereafter the motorcycle continued ahead at constant speed.",
#:   "It takes a particular sort of saloon driver. I'm behind him in the artic, leaving room, and he goes tap on the anchors. My coffee's on the dash. I settle down, and tap, he does it again, grinning in his mirror, and then off down the A1 he goes.",
#:   "I teach at a school near there and the bus ahead of me was plainly in a temper. Its rear end rose sharply, dropped, and a moment later rose sharply again, so I had to brake both times; after that it went on along its route as if butter wouldn't melt.",
#:   "Coach ahead gives us two spiteful nudges of brake and carries on.",
#:   "Let the ambulance in front brake-test the ego a couple of times, then proceed.",
#:   "biker in front scares me w 2 quick brake jabs n rolls on",
#:   "With nothing ahead of it, the taxi we followed dipped its tail lamps on and off with a jerk, repeated the threat a second later, and drove on.",
#:   "The lead target performs a brief brake input, recovers, performs another of like duration, and thereafter holds its speed ahead of the vehicle under test.",
#:   "Front lorry wallah gave one brake for frightening me, then again one brake same style, and after that he continued his journey like nothing has happened.",
#:   "Drop back a touch, he's cross with you: there's one stab of the brakes, there's another, and see, he's not stopping, he's off along the road as before.",
#:   "It was put to the witness that the SUV he was behind had pumped its brakes on two separate occasions solely to unnerve him before resuming its way.",
#:   "Twice the police van preceding us slowed for the blink of an eye, without cause, as one raps a knuckle on a table, and each time it rolled on.",
#:   "We were on an empty B road and I'd got a bit near, I'll own up to that. The pickup in front let me know. On came the red lamps and I nearly ate the wheel, off they went; on they came once more, and off. After which he motored along as if I'd never been born.",
#:   "V1's forward camera shows V2, the lead vehicle, with the roadway clear ahead. Its stop lamps illuminate for 0.6 seconds and it sheds about 12 km/h. Slightly more than a second later the same thing occurs again. V2 then continues in lane; its driver told police he had wanted to \"send a message\".",
#:   "It's what I call the old one-two. I'm behind a tipper with my caravan on, minding my business. He does a hard quick one on the pedal, and I back off; he does a second hard quick one and I back off some more. By the time I've stopped swearing he's humming along up there at fifty.",
#:   "A comment from the human factors group. The rider ahead is not reacting to anything; he's communicating. Hence a pair of sharp decelerations with a short relaxed interval, then cruise. Please make sure that the AV increases its gap after the first, does not change lanes, and treats neither as the start of a stop.",
#:   "My sister had the baby in the back so I was paying attention. You'd think a bus driver would know better. He lurched at us, backwards like, with his lights on red; we stopped breathing; he lurched again. It was purely to give us a fright, as he then went his way to the terminus without so much as a pause.",
#:   "The man wished to be obeyed and had only his brake lamps to say it with. He said it short and sharp, so that Julia's chin came down on her collar. He waited for it to sink in and said it a second time. Satisfied, he took his big grey saloon onward down the avenue.",
#:   "Two dents in my dashboard, both from the same forehead, officer, and about a second between the first and the second. The hatchback ahead hadn't anything to brake for, not so much as a cat. By the time I could focus again it was driving away in front of me at the old speed, her hand out of the window with one finger up.",
#:   "I am from Lyon, we know this sport. When you are too near, the one before you makes a blow of brakes. If you did not understand he makes a second blow of brakes. He has no intention to stop himself; it's to give the fear, and then he continues tranquilly, as he did on me.",
#:   "Clip of the day is called \"morse code\". The van in front of the cammer, for no earthly reason, goes dot on the brakes. The cammer squeals. A beat later, dot. The cammer squeals higher. And the van just keeps on driving into the sunset, message delivered.",
#:   "Unit 9, be advised, the motorist who rang in about the fire engine says it's been brake-checking her. One quick brake, nose down, then a second one directly after, nothing on the road before it. It hasn't halted, it's still heading up Union Street ahead of her. She's shaken, not hurt.",
#:   "Instructor here, twenty-two years. You tailgate a motorbike and this is the telling-off you get. His arm goes stiff and the light flares, that's once. You don't learn, it flares a second time, with a proper shudder through the bike. Then his arm goes soft and on he rides, and you, my friend, are sweating.",
#:   "Double flash of brake lamps ahead, pure malice, then onward.",
#:   "Van up front: jab, cruise, jab, cruise. Charming.",
#:   "red red from the lorry in front, twice, just to spook me",
#:   "The rear end of the taxi ahead curtsied at us, came up, curtsied a second time, and the taxi went its way as though we'd imagined it.",
#:   "I had the gap nearly lost and found again two times within five seconds, and no cat, no light, no queue; the SUV leading us wanted me frightened.",
#:   "He's sending you a message with his foot, son: one prod, off again, another prod, off again. Give him more room and he'll get bored.",
#:   "Lead actor: impulse of deceleration, 1.2 s at travel speed, second impulse, then normal cruise to the end of the segment. Intent: harass the follower.",
#:   "Have the police bike in front of the AV dab the anchors a couple of times with malice, a second's riding in between, and then continue up the road.",
#:   "It's a sort of Morse, the lady told the constable, two dots done with the brake to put the wind up whoever's behind, after which he merrily motors on.",
#:   "Our daughter's head went forward, back, forward, back. There was nothing on the road, I could see that over the low roof of the car leading us. It would simply lose a piece of its speed, take it up again, lose a second piece, take it up again; and the driver had his eyes on us in his mirror and grinned.",
#:   "Whoever reviews clip 88 should mind the distance trace. It has two dents in it, alike as twins, a little over a second apart. Either side of them it's flat. The coach we were following had a free road, its lamps flared at each dent, and when the ego had been properly rattled it resumed its old pace as if nothing was.",
#:   "I brake for a reason, I've been driving a wagon since '91. The pickup before me braked for the fun of seeing my cab dip. It dipped. He ran on a bit, long enough for me to think that's that, and he made it dip again. Then he'd had his laugh, and all I saw of him was him going on ahead.",
#:   "Did the ambulance want something? My father supposed so. It was empty, it had no siren, and there we were a decent length behind. Its back doors came at us for an instant and withdrew. He said \"hallo\". They came at us for another instant and withdrew. He said nothing, and let it draw ahead, and his hands were shaking.",
#:   "The noise of the evening was of shopping. Tins rolled against the front seats, rolled back, against the front seats, and back. The cause was the cab in front, where somebody who disliked my headlights touched something with his foot once, drove, touched it once more and drove. He never meant to stop, and he didn't.",
#:   "V2's brake switch signal shows two closures of 0.4 and 0.5 s. During the interval V2 returned to 25 km/h, and it held that speed after the second. Traffic ahead of V2: none. The operator of V2 stated that he \"wanted to teach the robot some manners\". V1 decelerated both times, and there was no contact.",
#:   "Our teacher on the motorcycle course says a lamp can be a fist. One day I knew what he means. I'm after another motorcycle, not near. His lamp: on, and I'm with the nose in my tank. Off, he rolls. His lamp: on, again the tank. Off, and he's rolling away and showing me with the hand a not nice sign.",
#:   "You don't have to be a detective. Someone who needs to slow does it once, till he's slow enough. This hatchback did it to me, undid it, did it to me afresh and undid that, with nothing but blue sky in front of it, and then toddled on at exactly the rate it had been doing in the first place.",
#:   "The letter to the bus company said: my wife is eighty and doesn't tailgate. Your driver nevertheless thought fit to make her stand on her brake pedal, to let her recover, and to make her stand on it again, with a clear road before him, whereupon he carried on along his route. Kindly tell us what he was playing at.",
#:   "I was braced for the third one that never came. First time the lorry's tail lights bloomed I thought deer. Then they were out and we were at our old trot. Second time they bloomed I thought, no, that's for me. They went out as well, and the miserable sod simply kept on trucking ahead of us, me with my foot hovering.",
#:   "Behaviour spec for the grumpy leader, in plain words. It's got no need to slow. It does it all the same, briefly, hard enough to make the ego flinch; it rolls on at town speed for a moment; it does the same thing over; and it rolls on at town speed for good. It must never come to a halt.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["brake", "follow"]
#: position = "ahead"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -15.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.6
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_BRAKE_TIME"
#: low = 0.6
#: high = 1.1
#: unit = "s"
#: meaning = "for how long it brakes"

param OPT_ADV_DISTANCE = Range(-15, 20)
param OPT_BRAKE = Range(0.6, 1)
param OPT_BRAKE_TIME = Range(0.6, 1.1)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) for globalParameters.OPT_BRAKE_TIME seconds
    do DrivePath(advTrajectory, 7) for 1.2 seconds
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) for globalParameters.OPT_BRAKE_TIME seconds
    do DrivePath(advTrajectory, 7)
