#: description = "The pedestrian runs into the road, then turns back to where it came from."
#: rephrasings = [
#:   "A person enters the lane and suddenly reverses direction to the kerb it left.",
#:   "The pedestrian changes their mind halfway and returns to the side they started from.",
#:   "Someone steps out, spots the ego, and retreats.",
#:   "The walker goes into the carriageway and hurries back again.",
#:   "Having reached the middle, the adversary about-faces and withdraws.",
#:   "She runs out, has second thoughts and nips back to the pavement.",
#:   "The pedestrian entered the roadway and then returned to the side of origin.",
#:   "ped into lane, reverses course, back to kerb",
#:   "A kid ran out, saw me and legged it back to the pavement he'd come from.",
#:   "The juvenile ran into the roadway, reversed direction, and returned to the curb.",
#:   "Ped runs in, about-face, back to same side.",
#:   "The child pedestrian target runs into the lane and then returns to its starting side.",
#:   "The boy runs on the road and then runs back again.",
#:   "Runner enters lane, flips heading 180, exits where it entered; once only, picks nothing up.",
#:   "She was half over before she saw the headlights, and she spun about and fled back to where she had started.",
#:   "Child's run out, he's seen you, he's turned tail, he's gone back to his mum.",
#:   "kid ran into the street then noped right back out",
#:   "A child dashed into the road but thought the better of it and hurried back to safety.",
#:   "She ran in, and then, never having reached the far side, she retraced her steps to the near one.",
#:   "The boy run out then scared already, run back same side.",
#:   "Runs out, clocks my cab, and it's back to Mummy double quick.",
#:   "Pedestrian dash into lane with reversal to side of origin",
#:   "NOPE! Runs out, spins round, runs back",
#:   "The runner rushes in and retreats to where he started.",
#:   "Girl races out, wheels about, races home to her kerb.",
#:   "Pedestrian: runs in, reverses heading, leaves by entry side.",
#:   "Out like a rabbit and back down the same hole.",
#:   "Bloke dashes into traffic, regrets it, dashes back",
#:   "Why run out at all if you're only going to run back?",
#:   "I need a child who sprints into the lane and, without ever getting over, spins on its heel and heads for the pavement it left.",
#:   "She was back beside the very lamp post she'd started from, having charged into the road and then thought again all in two seconds.",
#:   "The pedestrian ran from the west curb into the roadway, did not reach the east curb, and turned and ran again toward the west.",
#:   "The little boy comes running in the road, he turns himself around, and he is running to the same footpath where he was before.",
#:   "A jogger went into the road in front of our car at full pace, did a one-eighty on the spot and went off the same way.",
#:   "Mum shouted \"come here!\", and so the lad who had just pelted into our lane pelted right out of it again, to her side.",
#:   "His football had gone over the road and he went after it at a run. Some way into the carriageway he must have remembered what they tell them at school, because well short of it he whipped round, empty-handed, and ran as fast as he could to where his friends were.",
#:   "The runner enters the lane of the vehicle under test at constant running speed. As soon as the predetermined point in the lane is reached, the direction of movement is inverted and the runner goes back, at that same speed, to the side of departure.",
#:   "You could hear the tram bell, that's what did it. The student had bolted off the platform into our lane, heard the bell, and turned as if on a spring, so by the time we stopped he was up on the platform again as though nothing had been.",
#:   "Thing about the elderly is they don't trust their first idea. This dear old soul scuttled out in front of my truck faster than I'd have thought possible, took fright at the size of me, and straightaway scuttled back to the shop doorway she'd come out of.",
#:   "It's the return that fools the planner. A pedestrian who's running in from the left is expected to exit on the right, so the AV steers behind her; instead she flips direction within the lane and leaves on the left, which is precisely where we were steering.",
#:   "Runs in, thinks again, runs home to the kerb she left.",
#:   "Boy hurtles into our lane, about-turns, hurtles out again, same side.",
#:   "Jogger rushes in and rushes back, never reaching the other pavement.",
#:   "A man in an apron came tearing out of the café into the road, looked at our bumper, and tore back into the café.",
#:   "For this scene a girl runs from the right into the ego's lane and straight away, at the same speed, runs back to the right.",
#:   "She has come running in my lane, she has seen me, and hop, she has made the demi-tour and is running to the trottoir from where she came.",
#:   "Unit 6, child ran out on Maple, he's turned round and he's gone straight back to the yard he came from, no contact.",
#:   "Pedestrian left the west sidewalk running, got about two meters into the lane, reversed, and was on the west sidewalk again before V1 had stopped.",
#:   "You can stop shouting at him, he's gone; he shot out from that side, had a change of heart and shot back to it.",
#:   "My dog was on a lead, luckily, or he'd have gone too. The two of us were on the grass when a young fellow pelted past us into the road to catch his bus. It was the wrong bus, or so I gather. With a taxi nearly on him he swivelled and pelted past us in the other direction.",
#:   "The wet footprints told us all we needed. They come out of the pool gate and over the pavement, long strides. They enter the lane in which the lorry was travelling. In the lane they make a sort of comma, and then they go, with the same long strides, over the same pavement to the same gate.",
#:   "I'd braked so that she could get over. That was the natural thing, as she'd come off the left at a run and had most of the road before her yet. Most of the road remained before her for good, though: she whirled about in front of me, without a stop, and went off to the left as fast as she'd come.",
#:   "In this run the pedestrian dummy departs from the nearside kerb at 8 km/h. After it has entered the lane of the VUT by the given amount, the drive is reversed with no dwell, and the dummy is taken to its starting point at 8 km/h. A VUT which swerves to the nearside will strike it on its return.",
#:   "Have you ever watched a squirrel on a road? Half over, oh dear, half back. That's what an eleven-year-old in school uniform did to my bus on Monday. Out at full gallop, a look at sixty tons, well it must look like sixty, and then the selfsame gallop to the selfsame railing he had started from. I counted my passengers.",
#:   "My opinion, as the one who wrote that bit of the planner: it did nothing wrong. It saw a runner enter from the right, it expected her to be clear on the left by t plus three. She wasn't. She'd inverted her direction in mid-lane and was off to the right again, still running, and our gap opened on the wrong side.",
#:   "\"Come back this instant!\" You don't hear that voice twice. The little boy had got as far as our lane, legs going like pistons, and his intention had doubtless been the ice cream van on the other side of the street. He never arrived. He went about like a yacht, and those pistons took him to his mother.",
#:   "We pensioners in the window of number nine see the best of it. This morning a woman flew out of the salon with foil in her hair, into the road, she'd seen a traffic warden by her car on the other side. A horn went. And back she flew to the salon, foil and all, without having got over.",
#:   "Before the driver could so much as move his foot it was all over, and the lane as empty as it had been. A shape had rushed in from behind the parked hearse; the shape had turned on its heel; the shape was behind the hearse again. He sat for a while, he told the officer, and wondered if he'd really seen a man.",
#:   "The witness, a lorry driver, was quite firm that the deceased's brother hadn't crossed. \"He came at a run from the pub side. He got into my lane. Then he went back at a run to the pub side. He never stopped in between and he picked nothing up. Crossing's when you get to the other side, isn't it?\"",
#:   "street interview guy outtake, hes mid question and the dude hes interviewing spots his ex. LEGS it into the road, we're coming in the robotaxi, he sees us, spins like on ice and legs it back to the exact same bit of pavement. interviewer still holding the mic. robotaxi stopped like 3m away, respect",
#:   "pelted in pelted out same kerb like a second between",
#:   "Far kerb never saw her: ran on, whirled round, ran off.",
#:   "Into our lane full tilt, hairpin, off full tilt.",
#:   "The lad raced out before our bonnet, had a change of heart in mid-stride, and raced off it again, to where his mum was.",
#:   "I want somebody to come running into the lane, wheel about with no pause and be gone by the way they came.",
#:   "Two sets of wet footprints, wide apart, one leading into my lane and one leading out of it, both from the paddling pool.",
#:   "V1 braked for a runner from the right who, on reaching V1's lane, reversed course at once and ran off to the right.",
#:   "Who told that boy to rush into the road, and who told him, the moment he was there, to rush back to the fence?",
#:   "She came by running until the half of my lane, made there a turnaround like a swimmer, and ran away to the same side.",
#:   "A swimmer's turn is the best picture I can give you. He did his length at speed, off the pavement and into the lane of the bus. He touched the wall, only there wasn't any wall, just whatever made him think twice. And without getting his breath he did his second length at speed, back to the pavement that he'd dived from.",
#:   "The AV braked, waited for the runner to show up on the left, and waited in vain. She'd come tearing out from the right, that's well documented. There was no left for her. On the third frame after she got to our lane she's already facing right, hair swinging, and by the ninth she's at the railings that she'd left.",
#:   "Ball out, boy out, I expect you've had that one a hundred times. The ball went on over the road, and the boy did not. He'd come haring after it into my lane with his arms stretched out, heard the air horn, I suppose, and went haring back with his arms still stretched out. The far hedge got the ball.",
#:   "Count to two. One, there's a woman flying out of the betting shop and into your lane. Two, the same woman's flying into the betting shop. If you'd blinked you'd say that nothing had happened. You didn't blink and you braked, and that's why you'll be passing your test, and why she'll collect her winnings.",
#:   "I regret the bruise to your client's passenger, but my client had to stop. A man had entered his lane at a run. That he left it, at a run, by the selfsame side a moment later, does him no credit and makes no difference; at the time when the brake was applied he was running in, not out.",
#:   "Here's how pigeons differ from people. You throw bread on the road, a pigeon struts. My sister's girl, six, saw a coin. She was in front of that van as fast as her legs would go, and then her mother's voice got her by the collar, so to speak, and she was on her mother's side as fast as they'd go back.",
#:   "It's in the shoes. The pavement side has a heel print, dug in: that's her taking off. My lane has got a smear: that's her going round on the ball of one foot, no standing about. And the pavement side has a toe print: that's her landing at a run, where she began. Nothing beyond the smear, neither there nor on the other side.",
#:   "He is running, I brake. He turns, I still brake. He's running where he came from, now I can stop braking, and the man behind me hasn't even begun. This is how I have a bicycle in my back window. The jogger had music in the ears, maybe he wanted to cross, in the middle of my lane he did not want.",
#:   "\"Get back here!\" You can hear it on the tape, a second after a small figure in a cape has torn out between the parked cars and got to the middle of our lane. The cape swings round. Then you see only the lining of it, going away between the same parked cars. She hadn't stopped, she hadn't crossed.",
#:   "Purpose of the reversing runner: to catch systems that clear an object as soon as its velocity points out of the path. The figure enters at 10 km/h. It's turned on the spot through half a revolution in the lane, loses no time in doing so, and departs at 10 km/h to its origin. It will not return.",
#:   "It had been thunder, not a gun, but nobody told the poor man. He'd bolted from the arcade into the road ahead of our taxi, newspaper over his head, bound, one assumed, for the arcade opposite. The clap came. He turned a somersault, very nearly, and bolted into the arcade that he had bolted from, newspaper over his ears.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "turn-back"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.5
#: high = 5.0
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 10.0
#: high = 36.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 0.0
#: high = 1.0
#: unit = "m"
#: meaning = "how far from the ego's line it turns back"

param OPT_ADV_SPEED = Range(1.5, 5)
param OPT_ADV_DISTANCE = Range(10, 36)
param OPT_ADV_REACH = Range(0, 1)

behavior AdvBehavior():
    # Earlier where it has farther to go, and briskly where the ego would be gone otherwise.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(5) until abs(offsetFrom(egoRoute, self)) < max(2.5, globalParameters.OPT_ADV_SPEED * headway(egoRoute, ego, self) / 8)
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_ADV_REACH)
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 3.14159)
