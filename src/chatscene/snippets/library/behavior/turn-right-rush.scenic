#: description = "The car accelerates out of the side street, turning right into the ego's lane."
#: rephrasings = [
#:   "he guns it round the corner to squeeze in ahead of us",
#:   "Vehicle 2 accelerated from the stop line into a right turn ahead of Vehicle 1.",
#:   "right turn into our lane under hard acceleration",
#:   "The target, waiting at the line, accelerates while turning right into the lane of the VUT.",
#:   "The motorcycle turns right with full gas to be before the ego.",
#:   "A biker blasts out to the right into a gap that isn't there.",
#:   "The ambulance hurries off to its right just ahead of us, picking up speed.",
#:   "Without giving way, a hatchback scoots round to the right and puts its foot down.",
#:   "Someone came flying out of the side road, turning right into my lane with his boot down.",
#:   "Vehicle 2 pulled out of the side street, turned right into Unit 1's lane and accelerated.",
#:   "Side st. moto: R-turn into ego lane, full gas.",
#:   "The target emerges from the minor road, turning right into the VUT's lane under acceleration.",
#:   "The car comes quick out of the small street and turns right in my lane.",
#:   "Right-turner from the minor road jumps into our lane at full throttle; merges ahead instead of waiting.",
#:   "He whipped round the corner out of the lane and landed right in front of her, engine screaming.",
#:   "He's not going to wait at that side turning, he's hurrying out to the right, into your lane.",
#:   "he came flying round the corner to the right into our lane",
#:   "A motorcycle hurtled out of the side street, rounding to the right into the path of a van.",
#:   "You issued from the side street, rightward, into her lane, and you were quickening as you did so?",
#:   "From the small road he came out turning right into my lane, pressing full.",
#:   "Out of the side road like a cork, right-hand turn, into my lane, and no lifting off neither.",
#:   "Accelerated right-turn entry into ego lane from side street.",
#:   "SPEEDS OUT OF SIDE STREET RIGHT INTO MY LANE",
#:   "The motorcycle vaulted from the side street rightward into our lane.",
#:   "Hot hatch darts from the lane, right turn, hard throttle, our lane.",
#:   "Let a motorbike explode out of the side road rightwards before me.",
#:   "Side-street ambulance barrels out rightward, engine roaring, into my lane.",
#:   "He gunned it coming right out of the close, into my lane.",
#:   "Impatient cab, side street: turns right before us with everything it's got.",
#:   "The little Fiat had been at the give-way line, and as I came up it floored it round to the right, into my lane.",
#:   "From the small street on the side comes a motorcyclist, he bends right in front of us and he's making more and more speed.",
#:   "At the trigger the target leaves the minor arm, turning right into the ego's lane with a sustained positive acceleration of 3 m/s².",
#:   "You see him inching there at the mouth of the side road? Off he goes, right, foot to the boards, in front of you.",
#:   "Which is worse, that the police car emerged to the right just before me, or that it did so with its engine howling?",
#:   "Pedal mashed, a silver saloon swept right from Chapel Lane into the path of a district nurse, gaining pace all the way.",
#:   "There was a gap between me and the next man, not a big one. A girl in a convertible chose it, whipped the thing out of her street and round to its right, accelerating as if someone was timing her.",
#:   "V2 had slowed at the mouth of the intersecting street. Its driver elected to enter ahead of V1 and made a right turn into V1's lane under heavy acceleration, leaving a short curved tire mark and continuing to increase speed thereafter.",
#:   "This one's for the merging module. Somebody emerges from the side road, turning to the right and taking the lane we're in, and rather than dawdle he's on full power throughout, so the closing speed shrinks by itself if we lift.",
#:   "The biker had waited and waited at the end of his road. Seeing us he must have thought it now or never, since out he catapulted, heeled over to the right, and drew off down our lane with the exhaust crackling.",
#:   "I'm not fast on my bicycle, and I was about to pass the side turning. A big SUV that wanted my lane before I got there roared out of it, took its right-hander under my very wheel, and kept its foot buried.",
#:   "Right out of the side road, foot to the boards, our lane.",
#:   "Bike spears out rightwards into our lane, revs climbing.",
#:   "Squeals round to its right before us, gaining speed throughout.",
#:   "A tuned hatchback squirted out of Acacia Avenue, went right and had my lane, all in one long howl of second gear.",
#:   "Have the police car leave the minor arm by a right turn into the ego's lane, with the throttle open from line to lane and beyond.",
#:   "Out of the small street he shot to the right hand, in my lane, and he was giving gas and gas, the back wheels were smoking.",
#:   "What was the hurry, that she'd to bring the convertible round right into my lane with the engine screaming, instead of letting me go by?",
#:   "Motorcycle observed leaving side road, rightward, joining the lane of unit six directly ahead and winding it up hard, no injuries, rider made off.",
#:   "The shuttle lost its lane to an ambulance that, on the corner to our right, had come surging out and round to its right.",
#:   "Black marks, he calls them, signatures. There's one at the end of our close: it starts at the give-way line, bends round to the right and runs for twenty metres up the lane in which I was driving. He signed it under my nose, on Tuesday, in his father's coupé, and he was quicker at the end of it than at the start.",
#:   "It had waited so long at its line, that little sports car, that I took it for parked. When there was scarcely any gap left it took it. I've seen a cork leave a bottle less briskly. It came out to its right, in my lane now, tail squatting, and I with both feet on the pedal behind it.",
#:   "With the merging test we want no laggards. The actor is at the mouth of the side street; as the ego draws near he opens up and bends right into our lane. Both during the turn and after it he keeps piling on speed, which is why a mere lift, in theory, ought to be enough for us.",
#:   "You were right to keep your foot over the brake. Sat there like a cat at a mousehole, wasn't he? I heard the revs go up. Round to his right he's come, bit of wheelspin, and he's nicked your lane. Look, though, he's pulling away already, he's giving it plenty. So don't fret, let him go.",
#:   "V2 was stationary on the cross street facing a stop sign. According to its data recorder the accelerator was pressed to 100 percent as V1 approached. V2 executed a right turn into V1's lane and its speed rose from zero to 31 mph in 3.2 seconds. V1 avoided contact by braking and mounting the median.",
#:   "The road was mine, the evening was mild, and in the mouth of Vine Street a motorbike was clearing its throat. It cleared it properly when I was thirty feet off. Then it was all over the right-hand corner, leaning, spitting gravel at my fog lamps, in my lane, louder and smaller and louder and smaller.",
#:   "It's how these boys show off to the girls at the ice-cream parlour. They stand at the exit of the street, they wait until a car comes on the big road, it was ours, and then with full power out to the right, so that they fall in before your front bumper, the back going sideways and the speed always more.",
#:   "The defence says that he \"joined the main road\". Members of the jury, you heard the recording. You heard tyres; you heard an engine taken to its limit and kept there. He joined it, if you like, as a bullet joins the air: out of that side street, round to the right, into the one lane where there was somebody already.",
#:   "Fire service don't hang about, and rightly. I was coming along with a trailer of sheep, their lane-end was on my right, and the little fire car was in it. He'd no time for me and no time for my sheep. He was out, he'd gone right, he'd got the lane before me and was going through the gears.",
#:   "The bus braked; the cake didn't. That's the brief version. As to why: a woman in a white SUV had wanted to get into our lane from a side turning and had seen us, I know, since she looked. So it was hoof down. She slung it round to the right and was still accelerating when the cake hit the windscreen.",
#:   "robotaxi did good here imo. audi comes FLYING out the side st, turning right into our lane like 10m ahead, you can see the back end squat, full send. taxi just dabs the brake cos audi was already outrunning it. 5 stars, bit spicy",
#:   "Round the corner to its right, flooring it, our lane.",
#:   "Biker erupts from the side street, right, revs soaring.",
#:   "Full power out of the close, rightward, before our bonnet.",
#:   "By the time I had drawn breath to complain, the hot hatch that had burst from Mill Lane to its right was already three lengths up my lane and getting smaller.",
#:   "Ambulance has come out of the station drive, gone right, into the lane of a robotaxi, and he's booting it, the thing had to dab its brakes.",
#:   "In this variant the entrant from the minor arm has its throttle open during the whole right turn and goes on gaining once it is established ahead of the subject.",
#:   "She might have waited for me, it was one car; she preferred to hurl the convertible round to the right out of her road with the needle climbing.",
#:   "From the little street it made a scream, then the motorcycle was hanging in the curve to the right, then it was in my lane, ever louder, ever faster.",
#:   "What's the tell that he's not going to wait at that side turning? His back end drops, there, and he's swept out right and is off up your lane.",
#:   "All of what I know about the girl's car is the back of it, and of that I know less and less, since it was growing small so fast. It had no business being before me. It'd been in the mouth of a side road; a howl; a bit of a slide, rightward; and there were exhausts where I'd had a clear lane. I scarcely braked, it had gone by the time I might.",
#:   "There are those who pull out on you and make you a present of their slowness. This wasn't one. He sat with his engine singing at the end of Jubilee Terrace, waited till I was too near for comfort, and let it all go. Rubber on the corner, the bend being to his right. When the rubber ended he was in my lane, in second, flat out.",
#:   "The gap to the new lead vehicle behaves strangely, at first sight. It appears at nine metres, which is an alarm. Nobody brakes hard, yet a second later it's fourteen, and twenty-one after another. The explanation is on the right of the picture: that police car came off the minor road under full throttle, to its right, and just kept going faster.",
#:   "Our milk float does twelve. So when the young man from the garage wanted to be in my lane ahead of me, out of his side street, he had about a week to do it in. He did it in a second and a half. There were sparks as he went round, rightward, and a smell, and I heard him go through all his gears by the chapel.",
#:   "My mother had the window open and lost her scarf. It's because of the draught of the fire chief's car, that came out like a cannon ball from the alley, to its right, and in our lane it was still pushing, still pushing. We were close behind him, the first instant, so that I saw his neck. The second instant he was at the end of the street.",
#:   "\"Did he give way?\" No. \"Did he block you?\" You couldn't say block. He was at the give-way line on that big trail bike, and I was maybe three lengths short of him. He wound it open; it reared; he was round, in front of me, my lane, to the right as he'd look at it. And he was leaving. He'd left before I could be blocked.",
#:   "Put the foot over the brake and your ear to the window. Someone's revving in that side road. If he comes out to his right he'll be in here with us, so the question is how. Hear that? Like a dentist's drill. So he's coming out as though it's a race. Here he is, sideways, our lane, bless him, and still winding it up.",
#:   "V1's speed was 36 mph. V2 had been stopped at the mouth of a side street to V1's right. Gravel thrown by V2's rear tires struck a mailbox twelve feet behind the stop bar. V2's right turn terminated in V1's lane at 19 mph; its speed three seconds later was 44 mph. V1's driver braked lightly and the vehicles separated.",
#:   "They had the avenue to themselves, apart from the plane trees. One of the trees, it seemed to him, snarled. A low car came out from behind it where there must be a street, laid itself round to the right into the avenue, in front of them, and what had been a snarl rose, and rose, and was a thin bright line between the trunks.",
#:   "Merging properly, you match the others' speed. That's the theory. A certain SUV in our village joins from the lane by the vet's as though the theory is for people with time. It has the right-hander done on two wheels; it's there, on the road I'm on with the horse trailer; I hear its gearbox kick down a second time, and hay flies off my roof.",
#:   "dashcam title: \"bro was NOT waiting\". 0:03 side road, mustang, you can hear him loading it up. 0:04 he sends it, right turn, tyres spinning, lands in my lane. 0:06 hes already pulling away from me w the back end wagging. 0:09 gone. my ego: braking",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["accelerate", "turn-right"]
#: position = "crossing"
#: side = "right"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 40.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it accelerates"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.4
#: high = 0.8
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_DISTANCE = Range(12, 40)
param OPT_THROTTLE = Range(0.4, 0.8)

advTurn = ("straight", "right-turn")

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, 7) until abs(offsetFrom(egoRoute, self)) < 6
    do ThrottleOnPath(egoRoute, globalParameters.OPT_THROTTLE, 0, 9)
