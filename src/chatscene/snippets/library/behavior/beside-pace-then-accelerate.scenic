#: description = "The car keeps pace with the ego and then shoots ahead."
#: rephrasings = [
#:   "He matches us side by side and, the second we want over, guns it.",
#:   "Vehicle 2 travelled abreast of vehicle 1 and subsequently accelerated past it.",
#:   "Abreast, then full throttle.",
#:   "The target runs parallel at equal speed and then accelerates in the adjacent lane.",
#:   "He goes same as us and then gives a lot of gas when we want to change.",
#:   "The motorbike idles alongside and then catapults itself forward.",
#:   "A van level with our doors suddenly surges and closes the hole.",
#:   "Cheek by jowl until the other driver drops a gear and rushes on.",
#:   "This bloke sat alongside me for ages, door to door, then put his foot down and was gone.",
#:   "Vehicle 2 traveled abreast of Unit 1 for some distance, then sped up and pulled away.",
#:   "Bike level w/ us, same speed, then zooms off fwd.",
#:   "The adjacent vehicle holds the same longitudinal speed as the test vehicle, after which it accelerates and leaves it behind.",
#:   "Truck drives next to me same speed some time, after that it goes fast away to front.",
#:   "Neighbour-lane actor speed-matches, then full throttle and clears forward.",
#:   "He stayed at her shoulder as if they were tied together, and then all at once he bolted and left her standing.",
#:   "He's staying right next to you, ambulance on your side, let him be; there, he's hit the gas and taken off.",
#:   "he was driving right next to me matching my speed and then yeeted off",
#:   "The second car kept abreast for several hundred metres before surging clear.",
#:   "They travelled wing to wing, members of the jury, until the defendant chose to open up and leave my client in his wake.",
#:   "This van uncle drive same speed beside me so long, then suddenly zoom go front.",
#:   "Sits at my window like he wants a chat, then off he goes like a greyhound.",
#:   "Prolonged parallel running by adjacent vehicle, ending in a sudden gain of speed and departure ahead",
#:   "BMW matches my speed then VANISHES",
#:   "The rider shadows our flank and then rockets clear.",
#:   "Coach glued to our flank at equal speed, then it powers off forward.",
#:   "Let the motorbike shadow us alongside, after which it boots it.",
#:   "From neck and neck to a disappearing tail light: that was the Audi.",
#:   "Same velocity next to the AV, and after some seconds strong acceleration.",
#:   "An ambulance held station at our side before it opened the taps.",
#:   "For about half a mile the pickup ran beside me at precisely my speed, and then, for no reason I could see, it charged off up its own lane.",
#:   "The target shall remain alongside the VUT with zero relative velocity and, on reaching the trigger point, apply wide-open throttle in its own lane.",
#:   "Witness recalls a silver saloon travelling level with the subject vehicle, neither gaining nor losing, until its driver floored it and the car shot away in front.",
#:   "You'll often get one who sits in the next lane copying your speed; don't race him when he finally puts the hammer down and disappears up the road.",
#:   "Please create a truck in the neighbour lane that mirrors our speed for a while and then picks up pace strongly, still in its lane, going out ahead of us.",
#:   "control to four-two, the suspect motorcycle was holding level with the bus lane unit, now he's wound it on and is away up the road ahead",
#:   "Every time I eased off, so did he; when I sped up a bit, he did as well. It went on like that, mirror to mirror, along the whole embankment, until the lad in the hatchback dropped two gears and tore off into the distance.",
#:   "Vehicle 1 and Vehicle 2 were proceeding in adjoining lanes at matching speeds. Vehicle 2, a delivery van, had been level with the driver's door of Vehicle 1 for approximately ten seconds when its operator suddenly increased speed and drew far ahead, remaining in lane.",
#:   "I am seventy-nine and I don't like company when I drive. This bus stayed right there beside my window, going exactly as fast as I went, for what felt like an age. Then its engine roared and off it flew, leaving me on my own again, thank goodness.",
#:   "The interesting bit for prediction is the second phase. In phase one the neighbouring car simply copies our velocity and stays at our side, so the tracker gets lazy; in phase two it puts in full power and sprints off along its lane.",
#:   "Your honour, the police car drove next to my client as if tied to him by a string. Only when both had passed the petrol station did its driver hit the accelerator and leave my client behind, and not once did it leave its own lane.",
#:   "Level with us, level with us, then gone up the road.",
#:   "Neighbouring van copies our speed, then the pedal goes down and it's off.",
#:   "Door-to-door moped suddenly wakes up and streaks ahead in its lane.",
#:   "For eight seconds the coach next to the subject vehicle showed zero relative speed; thereafter it pressed on hard in its own lane and opened a gap.",
#:   "I'd like the SUV to hang beside us as if glued on and then, when we near the event point, sprint forward along its lane.",
#:   "he was riding next to me same speed same speed same speed then WHAAAM nothing but exhaust",
#:   "No matter what I did the motorcyclist remained at my elbow, until at last he wound the grip fully open and dwindled into the distance.",
#:   "As per my observation the lorry was running parallel with us, not one kilometre more or less, and afterwards only he raised full speed and went ahead.",
#:   "Why the hatchback had sat at the claimant's side at an identical forty before streaking off along the offside lane, its driver could not explain.",
#:   "I could read the whole advertisement on the bus, because for most of Kensington Road it hung outside my window and never moved an inch forward or back. I had just got to the telephone number when the letters began to slide away, faster and faster, and then there was only its smoke.",
#:   "My mother waved to the firemen, and they waved back, since for a good while they were sitting exactly level with us in the next lane. Then somebody must have called them. The engine note rose, the big red side slid forward past our window, and in no time they were dots.",
#:   "The reason I never changed over before the slip road is simple enough. There was a white van where I wanted to go, and it did not fall back when I slowed nor gain when I sped up. Only when it was too late did he give it full beans and clear off.",
#:   "V2, a tractor-trailer, had been running even with V1 on the adjacent lane for one quarter mile. Both operators reported no difference in speed during that interval. V2 then increased speed markedly while remaining in its lane and had a lead of several lengths by the time V1 reached the work zone.",
#:   "Two old boys on a Sunday run, that's how it looked from the footbridge, side by side as if they were chatting. I was about to put my camera away. Then the Triumph let out a howl and simply left the blue car there, straight on up the left lane.",
#:   "Log note, 11:06. Track 31 in the lane beside us, longitudinal offset constant within half a metre, so the fusion merged it with the guardrail for a time. It un-merged very visibly when its acceleration went to 3.5 and the offset grew to forty metres, lateral position unchanged.",
#:   "Never let somebody like that bother you. She's tucked in at your shoulder, matching you to the mile, and you can't go anywhere while she does. Just hold your line, hold it. And there, hear that, she's changed down and put her toe in it, and now the space is yours.",
#:   "Forty years I drove coaches and still it gives me the creeps, a car that won't go past and won't drop behind. This one stuck to my front wheel like a burr from the toll booths on. When it did finally make up its mind it went away as if it had been shot out of a cannon, lane and all.",
#:   "Il restait à côté, you understand, exactly at my height, the taxi. I could count his cigarettes. And when I arrive near the works he presses everything and he flies to the front in his corridor, and me, I look only at his little lights.",
#:   "Dash cam title: \"Dude babysits me for a mile then warp speed.\" You'll see nothing but his front wing on the left edge for ages, it doesn't creep up, it doesn't drop off. At 1:12 the wing becomes a door, a boot, a plate and a tiny red dot.",
#:   "It had rained, and the two of them ran abreast through the spray, the ambulance and the small grey car, so evenly that the one seemed the reflection of the other. What ended it she never knew. The ambulance gathered itself, drew out in front along its half of the avenue, and was gone.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["pace", "accelerate"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -8.0
#: high = 15.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = -10.0
#: high = 1.0
#: unit = "m"
#: meaning = "how far ahead of the ego it stays"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.6
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_DISTANCE = Range(-8, 15)
param OPT_ADV_AHEAD = Range(-10, 1)
param OPT_THROTTLE = Range(0.6, 1)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD, 16, 2.5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advLane, globalParameters.OPT_THROTTLE)
