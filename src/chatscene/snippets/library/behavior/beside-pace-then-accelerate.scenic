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
#:   "Neck and neck, neck and neck, then he opens the taps.",
#:   "The coupe matched us inch for inch before it sprinted off ahead.",
#:   "Same speed at my elbow for ages, then only taillights.",
#:   "What spoiled the photograph was that the bus, which had stayed exactly beside our window for half a minute, suddenly put on speed and slid out forward.",
#:   "The adjacent HGV is to show zero relative velocity until the event marker, and from there on pull away from the ego under full power in its own lane.",
#:   "I couldn't shake him off by slowing nor by hurrying; he was there at the shoulder, until he stamped on it and dwindled up the next lane.",
#:   "If the pickup next to us was a mirror, somebody broke it at the petrol station: up to there our twin, after it a dot in the distance.",
#:   "Let the motorcycle stay abreast as though roped to the robotaxi, and then have the rope cut and the throttle wide open.",
#:   "Er blieb neben mir like my own shadow, same tempo, and at the tunnel he has given everything and the shadow ran away forward.",
#:   "I'd been talking to the lad through the open windows, believe it or not, at forty, since neither car gained on the other. I was in the middle of telling him his boot was open. His engine drowned me out, the window I was shouting at moved on, and then the boot itself was far up the road.",
#:   "The relative-position plot explains the misprediction. For twelve seconds the neighbouring truck is a dot on the y-axis, neither ahead nor astern. The dot then climbs, slowly at first and soon off the chart, without once moving sideways. Our merge, which had waited for it to fall back, was cancelled in vain.",
#:   "You want to go left, there's an ambulance where you want to be, so you wait for it to go by or drop back. It does neither. You ease off, it's still at your door; you speed up, still there. And when you've given up, its nose lifts and the whole length of it goes by you up the road.",
#:   "In her statement the nun says she had been saying her rosary to the noise of an engine outside the glass. For three decades of it the noise was neither nearer nor farther, being level with her seat. At the fourth it turned into a bellow, moved forward along the other lane and was heard no more.",
#:   "I kept my hand over his headlamp on the window, it was a game. The truck was next to us and its headlamp was always behind my hand, even when Daddy went slower. Then I needed to move my hand to the front, and more, and more, and then my arm was too short because it had zoomed off.",
#:   "Transcript, unit 12. \"He's alongside me, lane two, same as me, fifty. Still alongside. I've dropped to forty-five and so's he. Back to fifty. He's clocked me, I think.\" Pause. \"He's off. He's dropped a gear and he's going, straight on in two, I've got his plate now, he's ten lengths up.\"",
#:   "My complaint is about the gap, or rather that there was none for a mile. A coach filled it. Every time I looked over, the same passenger was eating the same sandwich beside me. As we came to the lane closure, when it made no difference any more, the driver found his right foot and they all sailed ahead.",
#:   "Two riders' shadows lay side by side on the tarmac, one of a robotaxi and one of a man on a motorcycle, and from the bridge it looked like a single beast. At the second kilometre stone the beast came apart. One half, howling, grew longer and longer in front, and it kept to its own half of the road.",
#:   "Test drivers' debrief. We expected the SUV to move in on us, since that is what they do after pacing. It didn't. It had held our B-pillar for some ten seconds, at our speed to within one km/h; it then simply emptied its tank into the cylinders and left us by the front, its wheels never off its lane.",
#:   "In my trade you learn to hate the company of police. One was sitting level with my cab on the dual carriageway, not looking, just matching me, forty-nine, fifty, forty-nine. I'd already got my licence out, so to speak. Then something came on his radio and he flew, in a straight line, and I could breathe.",
#:   "Mon mari said: leave him pass. But the taxi did not want to pass, he wanted to remain at our side as a dancing partner, when we slow he slows. It is only when we arrived near the bridge that he changed of idea. His motor cried, his door went forward, his back lights also, adieu.",
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
