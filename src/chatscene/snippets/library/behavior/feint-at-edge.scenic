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
#:   "Cyclist charges at the road, front wheel kisses the kerbstone, stands.",
#:   "Jogger: full approach, dead halt at our lane's rim. False alarm.",
#:   "kid on scooter aimed right across us then slammed it at the edge, phew",
#:   "I had already braked for a crossing that was called off, the moped coming at our lane from the side with every sign of meaning it and anchoring up with its front tyre on the white edge line.",
#:   "The VRU shall approach the ego's path at right angles without any reduction in pace, so as to indicate a crossing, and shall be at rest before any part of it protrudes into the lane.",
#:   "Everything about the runner said he'd carry on over the road, his stride, his eyes, his course, except that both heels dug in at the very last flagstone.",
#:   "Your lane stayed empty, didn't it, yet you were right to brake: that boy on the BMX was coming over until his back wheel locked a hand's breadth short of it.",
#:   "Let somebody on a pushbike make as if to ride over in front of the robotaxi, then pull both levers so late that the tyre squeals at the gutter and remains there.",
#:   "A wobble of the knees, a squeak of trainers, and the woman who had been hurtling at our path was standing on the brink of it as still as a post.",
#:   "On the road you'll find the marks of my tyres and no one else's. His are on the drive, up to where the tarmac begins, and they're black. I saw the motorbike come down that drive at the sort of lick you use to shoot a gap, so I swerved. When I looked back he was sitting there with his front wheel on the last slab, waving sorry.",
#:   "The emergency stop emptied my shopping on to the floor. What for? For a man with a briefcase who'd marched off the station steps straight for my bonnet, not so much as a glance, and for whom I'd already written the obituary. His toecaps finished up level with the drain cover at the side. My lane he never touched.",
#:   "It is a question of the last half metre. A path prediction on the bicycle had it before our front wheels at t plus 1.3; there was no easing of the cadence and no steering. At t plus 0.9 the front fork compressed to its stop. At t plus 1.3 the thing that was to be before our wheels was stationary beside the road with its rider's foot on the kerb.",
#:   "We play chicken here, the little brother of my friend plays it best. One runs at the street when a car comes, very fast, so the driver must think now he is under me. But on the border stone one stands, like nailed. The driver makes a white face, his tyres are crying. The street itself, no, one goes never on it.",
#:   "I drive the school bus, and I'm up to all their tricks, but the lad on the racing bike had me. Head down, coming out of the park gate, and I mean coming. I said \"hold on!\" and stood on it, and twenty-six kids slid forward. I waited for him to go by the windscreen. He didn't go by. He was at the kerb with his brakes on, grinning.",
#:   "\"He'd decided to go,\" the constable wrote, \"and undecided when it was nearly too late.\" The approach of the motorcycle from the lay-by, as seen by the coach passengers, was direct and rapid and pointed at the opposite field. But its skid ends thirty centimetres outside the carriageway, and it was beside this skid that the rider was found, pale, astride, unhurt.",
#:   "For false-positive tuning. The pedestrian heads for the ego's lane at jogging pace, perpendicular, so that any sane predictor will say it crosses. Then zero velocity within one stride, toes outside the lane line, hold. We want a graceful dab and then progress. Last night's build did a full emergency stop for someone who was never on the road at all.",
#:   "I could draw you her face. It came towards the side of my cab above the handlebars, quite calm, like someone who has the road to herself, and I thought, that's it, that's my licence gone. Then she saw what was on the road, namely me. Her bike went up on its front wheel at the gutter. I drove by a yard from it with my eyes shut.",
#:   "The old soldiers called this a demonstration. One advances on the enemy's ground as if to take the whole of it and go beyond; one's boots are heard; the enemy, in this case my wife in the Morris, halts and prays. And at the very boundary one comes to attention. My grandson, aged nine, did it to perfection at the kerb of the London road.",
#:   "Look at the shadow, which arrives before its owner. It came out between the hedges, at speed, over my strip of asphalt, and I braked for the shadow. The owner was a scooter, and it had been going to follow; but there's a shriek of brake on the tape, and the shadow jerks to a stop with only its helmet in my lane. The scooter itself was still in the gap.",
#:   "So that's what a near-nothing looks like on a claim form. Third party vehicle: bicycle. Point of impact: none. Third party's position: at the side of the road. Why, then, did I hit the lamp post? Because until the last instant third party's position was going to be in front of me, by the look of how he flew at the lane. He then braked. I was already past braking.",
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
