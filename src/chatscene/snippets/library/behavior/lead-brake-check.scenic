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
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["brake", "follow"]
#: position = "ahead"
#: leader = false
#: blocker = false
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
