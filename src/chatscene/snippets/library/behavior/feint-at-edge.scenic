#: description = "The motorcyclist pretends to cross the road but brakes abruptly at its edge."
#: rephrasings = [
#:   "The rider lunges toward the carriageway and pulls up hard at the kerb.",
#:   "A motorbike feigns entering the street, then slams on the brakes at the border of the lane.",
#:   "The cyclist makes as if to go over and stops dead at the roadside.",
#:   "The adversary starts out as though it would cross and brakes sharply before the lane.",
#:   "The pedestrian runs at the road and stops short at the edge, confusing the ego.",
#:   "A fake crossing: it darts forward and halts at the very margin of the roadway.",
#:   "He makes out he's coming across and then pulls up short, the joker.",
#:   "The motorcyclist approached the edge of the roadway rapidly and stopped before entering the lane.",
#:   "lad on a pushbike made as if to come straight out, then slammed on at the edge, gave me a heart attack",
#:   "The pedestrian moved quickly toward the roadway as though to enter, then halted at the curb and did not step off.",
#:   "Cyclist rides at rd edge as if X-ing, stops dead at kerb. Never enters.",
#:   "The VRU target approaches the carriageway on a crossing trajectory and comes to a stop before the lane boundary (false positive test).",
#:   "The boy runs to the road, I think he will go, but he stops on the border and does not go.",
#:   "False alarm case: the scooter heads for our lane and brakes at the last moment; it never leaves the verge.",
#:   "She had run right up to the gutter as if to fling herself over, and there she checked and stayed.",
#:   "He's bluffing, look: charges up to the kerb like he's coming out, then on with the brakes and stays put.",
#:   "kid totally faked us out, ran at the road then stopped right at the edge haha",
#:   "A cyclist who seemed certain to dash out thought better of it at the very brink, to a driver's relief",
#:   "He made a show of crossing, your honour, yet his wheels never left the verge",
#:   "The scooter fellow acted like he will cross, but at the footpath edge itself he put brake, simply scaring us",
#:   "He shapes up to come out like a winger selling a dummy, then stops dead at the gutter",
#:   "Aborted crossing intention; road user arrests before lane boundary, spurious hazard",
#:   "Fake-out! Pedestrian charges the road and stops at the line",
#:   "The biker bluffed a crossing and balked at the brink.",
#:   "Scooter, mock charge at the road, anchored on the kerb line.",
#:   "Please simulate a pedestrian who threatens to step out but brakes himself at the edge.",
#:   "Psych! Boy sprints for the street, toes on the gutter, doesn't go.",
#:   "Bike fella dummied me, pulled both levers right on the verge.",
#:   "El chico, he makes like he will pass, stops hard before the road.",
#:   "A woman with a pram came at the road with such resolve that I stood on my brakes, only for her to haul herself back at the gutter.",
#:   "Bluff test: the powered two-wheeler moves towards the path of the VUT at 10 km/h and is arrested 0.5 m short of the carriageway boundary.",
#:   "I must have aged ten years when that moped rolled out of the alley as though for the far side and then dug in its front tyre at the kerbstone.",
#:   "Was it not the case that the cyclist gave every appearance of coming over, and yet his wheel came to a dead halt on the shoulder, outside the lane?",
#:   "Nothing happened in the end, because the jogger, who had looked certain to go over, threw out his arms and checked himself with his toecaps at the edging stones.",
#:   "Here's a prankster on a dirt bike. He aims it at your lane, gives it a rev, and then grabs the brake so he's left teetering on the brink, grinning.",
#:   "The robotaxi slowed needlessly, and I'll tell you why. A youth by the bus shelter set off towards the road with his head down like a man committed to crossing, and then stuck his heels in at the drain cover. He was never actually in our lane.",
#:   "I am seventy-nine and my nerves are not what they were. A young lady on a bicycle shot down the garden path straight for the road, and I was sure she was coming over, but she clamped on her brakes and drew up sharply with her front tyre still on the grass.",
#:   "Ticket 2291: the predictor assigned 0.94 crossing probability to a motorcyclist. He approached the road perpendicular to us from a farm track, clearly selling a crossing, then decelerated violently and held at the edge line. Ego emergency-braked for a manoeuvre that was not carried out.",
#:   "Dad says some kids do it for a dare. One ran right up to the road, pretending he'd go to the other side, and when we all yelled he skidded to a halt on the last bit of pavement and just laughed at us.",
#:   "I would like the ego to be tricked. Let a pushbike come quickly out of the park, heading for the lane at right angles as if nothing would stop it, and then have its rider brake so abruptly that it stands at the border of the road, outside our path.",
#:   "Skateboard kid charges, digs in at the kerb. False alarm.",
#:   "Cyclist bound for our lane, so it looked; both wheels locked short of it.",
#:   "Jogger \"crossing\", then isn't: full stop, toes over the gutter.",
#:   "You'd have sworn the girl on the scooter was coming straight over, yet when the dust settled her tyre was a hand's width outside the white line.",
#:   "Subject two-wheeler advances on the carriageway at right angles, thereby announcing a crossing, and is pulled up dead where the asphalt begins; the VUT's path stays free.",
#:   "Ach, I was so sure he goes over, the man with the dog, he came like a train, and exactly before the asphalt he rams his heels in.",
#:   "Make a moped rush out of the yard with every sign of continuing over the road, except that it nails its brakes where the verge ends.",
#:   "No contact and no incursion: the bicyclist, whose rapid approach caused the bus driver to brake, had pulled himself up with his front wheel against the curbstone.",
#:   "I hit the brakes for a lad who in the end never set foot on the road, though he'd come tearing down that bank as if he'd got to.",
#:   "He does it every afternoon, sir, the boy from the flats. He waits for a nice car, sprints down the steps with his eyes on the other side, and when the driver's gone white as a sheet he's standing there on the last slab, heels together, like a soldier on parade. Never goes over. Just likes the noise.",
#:   "My bumper ended up ten yards short of him, and he ended up a foot short of me, if that makes sense. He'd been riding his trail bike across the field directly at the road, and everything about him said he'd be over it. Then the front forks dipped right down and he was still, on the grass side of the ditch.",
#:   "There isn't a scratch on either vehicle, so I'm claiming for the wedding cake. It slid forward when I stood on the pedal, and I stood on the pedal because a woman on a bicycle came hurtling out of the churchyard towards my lane. As it turned out she could stop, and did, between the gateposts and the tarmac.",
#:   "The planner sees a tangent heading, a speed of three metres per second, a face turned to the far kerb, and rates the thing a certain crosser. But the person kills all that speed in half a stride and is left swaying on the kerb's rim. We braked for nobody; the lane was empty throughout.",
#:   "What a rotten trick. I was driving Grandma home and this big girl ran down the drive really, really fast and looked at the shop on the other side, so I screamed. And then she did a kind of emergency stop with her wellies. Her wellies were right on the line but not over it.",
#:   "In court we shall hear much of the motorcyclist's intentions. I ask you to attend to his tyres. They brought him from the car park with a roar, pointing squarely at the opposite pavement; and they brought him, with a squeal, to rest before so much as a spoke had passed the edge of the carriageway.",
#:   "Our robotaxi isn't easily taken in, but this one took it in. A pedestrian with a suitcase made for the road at a run, head up, eyes on the hotel opposite. We all swung forward in our belts. He, meanwhile, had dug in on the brink and was waving us through, the suitcase rocking on the kerb.",
#:   "So the mare bolted, and what saved her was that cyclist not being on the road after all. He'd come pelting along the bridleway to where it meets the lane. I took him for a goner. He had such brakes on that bike, though, that it stood on its nose with the verge still under it.",
#:   "Observe the body language. Shoulder forward, pedals level, chin pointing over the way: that says \"I'm going\". Now observe the hands. Two fingers on each lever, and bang, he's anchored, right on the boundary, without an inch of him in your lane. You were right to slow down, mind, he might have meant it.",
#:   "I drove trams before lorries, and tram men have a word for it, we called them matadors. He trots up to you from the side as though the road's already his. You're reaching for the sand. And then he goes up on tiptoe on the edging stone, arms windmilling, and lets the beast go by.",
#:   "The footage has been checked frame by frame because I wanted to know if I'd imagined it. The scooter comes out from between the bins at a fair lick, straight for us. Its nose goes down at the exact place where the paving gives way to the road, and in the next forty frames it hasn't moved.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario turning-obstacle; own code"
#: [slots]
#: actions = ["brake", "stop"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.5
#: high = 7.0
#: unit = "m/s"
#: meaning = "how fast it rides at the road"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 2.0
#: high = 16.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 1.4
#: high = 2.3
#: unit = "m"
#: meaning = "how far from the ego's line it comes to rest"

param OPT_ADV_SPEED = Range(3.5, 7)
param OPT_ADV_DISTANCE = Range(2, 16)
param OPT_STOP_DISTANCE = Range(1.4, 2.3)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt()
