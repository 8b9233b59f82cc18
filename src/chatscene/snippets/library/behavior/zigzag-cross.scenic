#: description = "The pedestrian staggers across the road in a zigzag."
#: rephrasings = [
#:   "A person reels over the carriageway from one slant to the other.",
#:   "The drunk pedestrian sways to and fro while crossing.",
#:   "Someone crosses the street in a wavering line, veering each second.",
#:   "The walker zigzags through the lane ahead of the ego.",
#:   "The pedestrian's course over the road swings erratically left and right.",
#:   "Some drunk comes lurching over the road, left, right, left.",
#:   "The intoxicated pedestrian followed an erratic path across the roadway.",
#:   "ped crosses zigzag, unpredictable",
#:   "this fella was tottering over the road all over the place, one way then the other, three sheets to the wind",
#:   "The pedestrian stumbled over the street in an erratic, zigzagging manner.",
#:   "Ped X-ing, zigzag track, unsteady.",
#:   "The pedestrian target crosses at normal walking speed on a zigzag path with alternating heading.",
#:   "The man goes over the street not straight, but always here and there, like a lightning.",
#:   "Crosser with polyline path: heading flips left/right at each leg; normal walking velocity.",
#:   "She tacked over the road like a sailing boat, stumbling off to one hand and then to the other.",
#:   "Walker coming over, and he can't keep a straight line, he's lurching off left, off right, you can't tell where he'll be next.",
#:   "drunk guy crossing like a pinball left right left right",
#:   "A partygoer tacked over the street like a dinghy in a squall",
#:   "He did not cross in a line at all, but first this way and then that?",
#:   "One man crossing the road zigzag zigzag, cannot tell which side he will go",
#:   "He's had a few, coming over the road in a string of Zs",
#:   "Erratic zigzag crossing path of pedestrian",
#:   "Pedestrian ZIGZAGS across the road, where is he going??",
#:   "The walker tacked and lurched across.",
#:   "One tipsy reveller, crossing in lurches, one way, then the other",
#:   "Let a pedestrian cross by way of a jagged, tottering course.",
#:   "Ped going over, stumbling left, stumbling right, track like a sawtooth.",
#:   "The man walked over the road like our dog sniffing, this way, that way!",
#:   "Can't he walk straight over, instead of stitching his way across?",
#:   "Coming out of the pub, a man went over the road before us in short slanting staggers, each one pointing somewhere other than the last.",
#:   "The pedestrian target traverses the carriageway on a piecewise linear path, its heading alternating between left and right of the direct line at each segment.",
#:   "I had no idea which side to leave for him, since he was reeling over to the far pavement by way of one corner after another.",
#:   "The pedestrian, reportedly intoxicated, crossed the roadway in front of V1 on an irregular course, alternately veering in one direction and the other.",
#:   "A young woman in one shoe was making it to the other side by zigs and zags, and her steps were anything but sure.",
#:   "He is full of alcohol, my friend, he crosses street like a snake with sharp corners, now to right he is falling, now to left.",
#:   "It was gone two when the hen party broke up. One of them made for the taxi rank opposite, and she did it the way a fly gets over a window, a bit to one side, a bit to the other, tottering at each corner.",
#:   "Straight-line extrapolation fails on this one, and that's intended. The walker gets over the road in front of the AV at an ordinary pace but changes the slant of his path every half second, stumbling now leftwards, now rightwards, until he has reached the kerb.",
#:   "Take your foot off, he's not well or he's had a drop too much. He wants the other side, fair enough, but look how he's getting there, tacking one way, catching himself, tacking the other, with all the width of the street for it.",
#:   "The old sailor left the tavern and laid a course for the chandler's over the way. The street, it seemed, was heaving under him, for he lurched off to port, then to starboard, then to port again, and so gained the far shore.",
#:   "From my saddle I watched the whole performance. A fellow with a kebab set out to get across in front of a grey estate, and his feet took him on a string of sharp bends, first towards the lights, then towards the church, then back again.",
#:   "Reveller reels over, path like broken lightning, kerb to kerb.",
#:   "Ped crossing on a sawtooth, feet not agreeing with each other.",
#:   "bro crossed the road like he was dodging snipers, wobbling every corner",
#:   "He meant to go straight over, no doubt, but his legs took him there by a chain of short slants, this way and that way.",
#:   "The adult target crosses with heading alternating by plus and minus 40 degrees at intervals of roughly half a second, simulating impaired gait.",
#:   "She's getting to the other side, never fear, but she's lurching off at a new slant every couple of steps, so leave plenty of room all round.",
#:   "From our bonnet I have watched a man who wanted to the other sidewalk and who always stumbled in one corner, then in the opposite corner.",
#:   "Simulate somebody, the worse for drink, whose way over the carriageway is a string of sharp bends, first leftish, then rightish, until it's done.",
#:   "According to onlookers the pedestrian staggered from the north curb to the south one in a series of oblique changes of direction before V1's front end.",
#:   "There had been a wedding at the Crown. One of the ushers needed the cash machine over the way, and he got there, but if you'd tied a piece of chalk to his ankle it would have left the road covered in W's; he pitched off one way, caught himself, and pitched off the other.",
#:   "I did what you're supposed to and aimed behind him. He'd been heading away to my left. Next thing he was heading to my right, and that was in two strides, so I aimed behind him again, and he'd changed his mind again; he only got over because I stopped aiming.",
#:   "We fitted the trajectory afterwards. From one kerb to the other it is made of nine straight pieces, each at an angle to the last, and the turning alternates: left, right, left, right. The pace along them is that of a normal walk, if one leaves out the stumbles.",
#:   "The man had a football scarf on and only one glove. He tottered down off the pavement towards the chip shop opposite and had clearly chosen it as his mark; the trouble was that the mark seemed to jump, for he veered off to this side and to that, and back, all the way over.",
#:   "At the inquest the landlord was asked if Mr Dunne could walk. Walk, yes, said he; walk straight, no. On leaving he'd gone across the street by lurches, the first of them up the hill, the next one down it, and so forth, while the cars waited for him to land on the other side.",
#:   "Somebody ought to have taken her arm. She was going over the road in front of our bus, in a party hat, and each time that her feet ran away with her to the one side she hauled herself round, and then, of course, they ran away with her to the other.",
#:   "Why did the robotaxi brake four times for one person? Its forecast was redone at each of his corners. He was reeling over from the kebab van, and by every forecast he'd leave the lane to the left, or, half a second afterwards, to the right.",
#:   "The snow kept a record until the plough came by. There were the prints of one pair of boots, quite deep, and they left the tavern side of the street and reached the church side; but between the two they ran to and fro like the stitching on a baseball, with here and there a handprint.",
#:   "I ride home about closing time and I've become a student of gaits. Last night's specimen was getting across in front of a stationary grey car, staggering; he did two steps towards me, two steps away from me, two towards, two away, so I got off and let him finish.",
#:   "There's a knack to drunks, and it's not to guess. See that chap coming over? He's pointing at the post box, now he's pointing at the bank, now at the post box again; he will fetch up on the far pavement in due course, by all those crooked little tacks.",
#:   "After Holi, what to say. One uncle, pink from head to foot, was crossing before my car, and not like a person, like a kite whose string somebody is jerking: to this side he fell, to that side he fell, each time a new corner, and in such a way he reached the paan shop.",
#:   "Over the road by N's and Z's, knees none too sure.",
#:   "Left-ish, right-ish, left-ish, and somehow he's reached the other kerb.",
#:   "Bet you couldn't draw a straighter W than that bloke's crossing.",
#:   "Her heels clicked off in one direction, skidded, and clicked off in another, and by half a dozen such slants she got herself to the far pavement.",
#:   "Each of us three pulled over to leave him room on a different side, and each was right for one second, till he'd tottered over.",
#:   "Have somebody make for the opposite side on a track like folded paper, a slant one way, a crease, a slant the other way, knees giving at each crease.",
#:   "He's for the chip shop over there, but look at his feet, they're taking him by way of everywhere; every other step he's off at a new angle.",
#:   "P1's path from curb to curb comprised seven straight segments alternately inclined to the left and to the right, an unsteady gait being noted at the turning points.",
#:   "The gentleman had drunk his own weight; he conquered the street as one goes up a mountain, in hairpins, and at each hairpin I believed he falls.",
#:   "We'd been told that there was a marathon, so I took him for one of those at first, the way his legs were going. They took him over the road, I'll say that. But it was three strides towards the river, a stagger, three strides towards the hill, a stagger, and we sat there turning our heads like at tennis.",
#:   "What she was carrying was a tray of eggs and she'd have kept more of them sober. There is a yolk here, nearer the lamp; one there, nearer the tree; here again. If you join them with your finger you've her way over the road in front of us, and it's as crooked as lightning.",
#:   "The forecast cone is what you should look at. It swings like a windscreen wiper. The person's going over from one side to the other at an ordinary pace, we never doubted it; only the slant at which he does it flips at every third step, as his legs buckle, from half left to half right and round again.",
#:   "I'm a nurse, and I'd say low sugar and not drink, if it please the court. She was trying for the pharmacy across the road. Her body would set off some way to one side of it, she'd correct, and overcorrect, so she'd be off to the other side; a dozen of these staggering slants and she had the doorhandle.",
#:   "It's easier from above. I was cleaning windows. Down on the road there was a black cap with a white bobble, and the cap was on its way from the Swan to the bus stop. It'd have made a good sewing machine. Jag, jag, jag, to one hand and to the other, and a blue taxi waiting until it ran out of thread.",
#:   "You can't steer round someone like that, and I didn't try; I stood on the brake, put the flashers on and let him have the full width. He'd lurch at my left headlamp, think again, lurch at my right one. All the while he was gaining on the far kerb, mind you, a foot for every two he spent.",
#:   "Our youngest calls it the penguin. They'd had a penguin at the zoo which wanted to go to the fish bucket. It leant one way and had to run that way, and it leant the other way and had to run there. That's just how the man got across the street in front of us, zig, zag, zig, zag, to his friends.",
#:   "From the tachograph I can prove I was stopped for nine seconds. I cannot prove what for, so here goes. One reveller, in antlers. He left the left pavement for the right one, and he tacked, like my brother's dinghy does, only that with a dinghy one hears \"ready about\". He fell into each new tack without a word.",
#:   "The moon laid a white path over the street and he, it seemed, was resolved to take it. It wouldn't lie still for him. He was off it on the near side and came reeling back; he was through it and off it on the other; and thus, sewing it to the dark with great unsteady stitches, he arrived beneath her window.",
#:   "Any car can stop for a person who crosses. We wanted a crossing that a car has to go on being stopped for. Whichever side the walker opens up by staggering off to the left he shuts again with the next few steps, which go off to the right; so the AV has to wait until he has tottered onto the kerb.",
#:   "He is our school's PT master, what shame. From wine shop to auto stand is only ten metres straight. He made it thirty. To the north side two steps, legs became noodles; to the south side two steps, again noodles; like he is teaching us zigzag run, but in sleep. My van waited, full class clapping.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "weave"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.5
#: high = 4.0
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 14.0
#: high = 42.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_ADV_ANGLE"
#: low = 0.6
#: high = 1.0
#: unit = "rad"
#: meaning = "how far each leg slants"

param OPT_ADV_SPEED = Range(1.5, 4)
param OPT_ADV_DISTANCE = Range(14, 42)
param OPT_ADV_ANGLE = Range(0.6, 1)

behavior AdvBehavior():
    # Earlier where it has farther to go, and briskly where the ego would be gone otherwise.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(5) until abs(offsetFrom(egoRoute, self)) < max(2.5, globalParameters.OPT_ADV_SPEED * headway(egoRoute, ego, self) / 12)
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE) for 0.6 seconds
    while True:
        do MoveAhead(globalParameters.OPT_ADV_SPEED, -2 * globalParameters.OPT_ADV_ANGLE) for 1.2 seconds
        do MoveAhead(globalParameters.OPT_ADV_SPEED, 2 * globalParameters.OPT_ADV_ANGLE) for 1.2 seconds
