#: description = "The parked car pulls out and wobbles from side to side in the ego's lane."
#: rephrasings = [
#:   "Straight from the pub he pulls out and wobbles along ahead of us.",
#:   "Vehicle 2 departed the curb and swerved repeatedly in the lane.",
#:   "Parked veh out, then snaking.",
#:   "The target leaves the parking strip and oscillates laterally in front of the VUT.",
#:   "It comes out and goes like a snake.",
#:   "A tipsy scooter rider wavers off the roadside and on down our lane.",
#:   "The overloaded van lurches out and rocks left and right.",
#:   "A driver fumbling with his belt pulls away and meanders.",
#:   "Someone came off the kerb in front of me and then wandered all over my lane like he'd had a few.",
#:   "The vehicle departed its parked position and was observed drifting left and right within the travel lane; possible DUI.",
#:   "Parked moto leaves kerb, then zigzags ahead of ego.",
#:   "After leaving the kerbside the target oscillates laterally in the VUT's lane.",
#:   "The parked car goes out and then drives like snake before me.",
#:   "Pull-out actor isn't stable afterwards: sinusoidal path in our lane, side to side.",
#:   "He wobbled it out from the pavement and then couldn't keep it straight, now towards the gutter, now towards the line.",
#:   "He's pulled away from the kerb and he's snaking about in front of you, so don't try to pass.",
#:   "car pulled out from the side and was swaying all over like drunk af",
#:   "A motorist suspected of drinking left his parking place and meandered from edge to edge of the lane.",
#:   "After leaving the kerb, the motorcycle did not hold a straight course, but strayed to and fro ahead of my client?",
#:   "The parked bike came out and then shaking shaking left and right in my lane.",
#:   "Off the kerb he comes and then he's drawing snakes in my lane, three sheets to the wind I reckon.",
#:   "Lateral instability of vehicle following kerbside departure in ego lane.",
#:   "PARKED CAR PULLS OUT AND CAN'T DRIVE STRAIGHT",
#:   "The parked car came out and meandered ahead of us.",
#:   "Leaves the parking bay, then can't keep it straight in our lane.",
#:   "Parked scooter sets off and teeters left, right, left before us.",
#:   "Ambulance departs kerbside, then slaloms within VUT lane.",
#:   "Who parks up, sets off again and staggers down my lane like that?",
#:   "Off the roadside it comes, and sways along our lane.",
#:   "Let the saloon that was parked by the pavement move off into the ego's lane and keep swinging gently to either side as it drives on.",
#:   "The hatchback had been stationary outside the off-licence; it joined the lane ahead of the robotaxi and thereafter never stopped yawing about.",
#:   "The moto was standing at the trottoir, it enters in my lane and then it dances, one time left, one time right.",
#:   "V2 entered the travel lane from a curbside space and was seen to drift repeatedly from one edge of that lane to the other.",
#:   "Control, that stolen Corsa has just left the kerb on Park Street and it's rolling all over the lane, left and right, can't steer.",
#:   "A new rider, you see: he's got himself off the kerb into our lane, and now the bars are shaking and he's wavering about.",
#:   "It was ten past one, chucking-out time. A chap I'd seen fumbling with his keys got into the Vectra by the kerb, moved out in front of me, and then all along Church Road he was touching the centre line, touching the gutter, touching the line.",
#:   "Before the collision, Vehicle 2 was legally parked. Its driver, later found to be unwell, steered it into the traffic lane and continued in it, but not in a straight line: over a hundred metres the tracks show five alternate deflections to left and right.",
#:   "You think the hard bit's done once the parked car has come out and you've braked for it. Not with this fella. There was a wardrobe on his roof, and as soon as he was in the lane it began to swing, and the car swung with it.",
#:   "Actor timeline: parked at the right edge; on trigger it leaves the bay and takes up our lane; from then on its lateral position follows a periodic curve around the lane centre, so that neither side leaves enough space to get past.",
#:   "When they found the fire engine's steering had been tampered with, it was too late, for it was already out of its place by the kerb and lumbering ahead of us down the lane, leaning to this side and then to that with its ladder waving.",
#:   "Parked moped joins our lane, then can't stop waggling.",
#:   "Ambulance leaves its bay and yaws along before us.",
#:   "From standing at the pavement to slaloming down our lane.",
#:   "The hire van had been standing by the shops; it moved off in front of us and from then on wandered to and fro like a lost dog.",
#:   "Start with a stationary hatchback at the roadside, let it emerge into the ego's lane and have it swing left and right there while driving.",
#:   "Notice anything about that car that's just come off the kerb, Liam? Quite right, he's rocking from gutter to white line, so hang well back.",
#:   "Stationary police motorcycle departs the edge, takes up position in VUT lane, thereafter lateral oscillation, period three seconds, until end of test.",
#:   "Old Mr Hopkirk got his Rover out of its usual spot by the post office, into our path, and tacked up the lane like a dinghy.",
#:   "The scooter, he quits the bord of the road where he was put, he takes my lane, and in it he makes zig, zag, zig, zag.",
#:   "A patient of ours rang to say she felt dizzy but would drive in anyhow. I was two cars down from her house, as it happens. Her Yaris came away from the pavement and into the lane ahead, and I could watch her drift towards the parked cars, haul off, drift towards the centre, haul off, the length of the avenue.",
#:   "There's a stand for hire motorbikes by the beach, and every one of them is rented to somebody who has never ridden. This chap wobbled off it straight into our lane, that was expected. What we'd hoped was that he'd find his balance after that. He didn't; the front wheel flopped from one side to the other all the way to the pier.",
#:   "V2 had been parked along the east curb for approximately two hours according to the meter. The operator drove it from this position into the southbound lane ahead of V1. V1's operator stated he was unable to pass, as V2 kept meandering between the curb line and the lane line. A breath test of V2's operator followed.",
#:   "The clip starts with an ordinary row of parked cars, and the third of them puts its lights on. It noses out, gets in front of the robotaxi, fair enough. Watch its rear wheels now: nearer the left line, nearer the right line, nearer the left. The caption reads \"me steering with my knees while I unwrap a burrito\".",
#:   "What we smelled first was chip fat, as the catering van went by, or rather as we caught it up. It had set off from the lay-by right before us with its awning still half out. That awning caught the wind, and it was for this reason that the van kept sheering to one side of our lane and being hauled to the other.",
#:   "For twenty seconds the AV's overtaking planner computed a gap on the left, then a gap on the right, then one on the left. All these vanished as fast as they opened. The fire chief's car, which had stood by the kerb before it came out into the AV's lane, was swaying across that lane with a three second rhythm.",
#:   "I was in my wagon with nineteen tons on. A girl in a Corsa came off the kerb into my road, no harm in that, I'd seen her wheels turn and I'd eased. But then she starts doing her mascara, doesn't she, and the Corsa's off to the left, off to the right, off to the left, and me behind it like a nanny.",
#:   "\"It isn't that he came out, Sergeant,\" she said, \"people will do that. It's how he carried on.\" The ambulance had left its place beside the pavement and gone in front of her; and then, as if the road were a deck in a swell, it had rolled from this edge of the lane to that edge, and from that to this.",
#:   "Set-up: adversary parked on the right, engine running. As the subject vehicle approaches, the adversary enters the lane. From when it is in line with the lane its steering is given a sine input, such that it snakes round the centre of the lane at the same speed, making any attempt at passing within that lane unsafe.",
#:   "My flatmate got a 125 for Christmas, no lessons. I drove behind to make sure he'd arrive, lucky me. He had it parked outside, kicked it off the kerb into the road in front of me, ok. Then two miles of watching his back light go left right left right in my lane like somebody was wiping a window with it.",
#:   "The defendant maintained that he was sober. The bench was asked to consider the shape of his journey: a parked saloon, unlit, leaves the kerb outside the Railway Arms and enters the lane just before a taxi; and the taxi driver, obliged to crawl behind him, counts eleven swings from one edge to the other.",
#:   "Left its bay, joined our lane, couldn't find the middle.",
#:   "parked scooter sets off in front of us rolling about like a dingy",
#:   "Roadside ambulance, now in our lane, fishtailing from edge to edge.",
#:   "It had been minding its own business outside the bank; next, it was ahead of me and polishing both edges of my lane in turn.",
#:   "The gap to its left and the gap to its right kept changing places, ever since that parked Mini had come off the kerb before us.",
#:   "Let a motorcycle that is standing at the pavement's edge take to the ego's lane and keep swinging about in there as it goes along.",
#:   "Why is that van, which was parked until you got here, now in front of you and driving as if the road were ice?",
#:   "He was stood at the side, he came out, and from then on I had his left tail lamp, his right tail lamp, his left tail lamp in my beams.",
#:   "A police car unparks itself ahead, enters the lane of the VUT and subsequently oscillates about the lane centre until the test is terminated.",
#:   "What made me stay back was the roof box. I could see it swaying, first over the drain covers, then over the white line, then over the drain covers again, all the way up Park Street. At the start of Park Street it hadn't swayed at all, because it had been parked, and I'd given way to let it out.",
#:   "An empty space by the florist's, and a trail of potting compost that starts from it. It goes out to my lane. Along my lane it goes like icing on a cake, from one side to the other, and ahead of it, with the back doors open, the van that was losing it. So you see, it's not hard to reconstruct.",
#:   "If he'd come out and gone, fine. If he'd come out and stopped, I can stop too. But the gentleman on the motorbike left the kerb right ahead of my lorry and then just couldn't keep the thing upright in a line: verge side, middle side, verge side, with me behind him in bottom gear, holding my breath and forty tons.",
#:   "Our car learned something. Two hundred metres of it. It had seen the estate's wheels turn out from the parking strip and it had let it in ahead. From there on it tried to compute where in the lane the estate was, and the answer was different each time: minus sixty centimetres, plus seventy, minus seventy, plus sixty.",
#:   "Mummy said don't look, so I looked. The lady with the sunglasses came out of where the cars sleep. She was in front of us now. And her car was going like when I do the steering at the fair, all the way this way and all the way that way, and Mummy said she's putting her lipstick on.",
#:   "When the fire service takes its old pump for a run, the whole village knows. It stands by the pond. It was got going as I came up, and it rumbled off the verge and in front of me. The steering's worn out, though, and for the next half mile it wandered from hedge to dotted line like a cow going home.",
#:   "In the deposition it's the word \"straight\" that is in dispute. Mr Kumar had been stationary at the kerb, this is agreed. He had come away from it into the lane, ahead of the robotaxi, this also. But nobody except Mr Kumar believes that he was driving straight thereafter; the tape has his brake lights visiting both lane markings four times.",
#:   "Rule number one: a car with a driver in it and steam on its windows isn't parked. Rule number two: if it comes out in front of you with the windows still steamed up, don't pass. He can't see a thing. Look how he's feeling his way, over to the left, whoops, over to the right, whoops. Like a bee in a bottle.",
#:   "Yesterday evening I learned the word \"Schlangenlinie\" from my landlady. We were behind a motor scooter which had stood before the kebab shop. He had a bag on each arm. As he had us passed the kerb and was in our lane, the bags began to swing and he with them, to the gutter, to the middle, to the gutter.",
#:   "Not for one moment did the steering wheel rest. I was close enough to see it through the rear window: quarter turn left, quarter turn right. That was the taxi which had been idling at the edge of the pavement and which had shoved in ahead of us when the rank emptied. We trailed it, at a distance, through this slalom without gates.",
#:   "There's something very wrong with the axle, writes user spanner74, and I agree. 0:05, ambulance at the roadside, engine on. 0:09, it's moved out, it has got the cammer's lane. From 0:11 to the end the whole box is yawing, you get a bit of left flank, a bit of right flank, a bit of left flank, and the cammer hangs back.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["advKerb", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "weave"]
#: side = "right"
#: position = "kerb"
#: place = "road"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 14.0
#: high = 34.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.5
#: high = 4.5
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 0.9
#: high = 1.3
#: unit = "m"
#: meaning = "how far it swings to either side"

param OPT_ADV_DISTANCE = Range(14, 34)
param OPT_ADV_SPEED = Range(2.5, 4.5)
param OPT_ADV_AMPLITUDE = Range(0.9, 1.3)

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3) for 0.3 seconds
    do DrivePath(ownLane(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(ownLane(egoRoute), self)) < 1
    do WeaveOnPath(ownLane(egoRoute), globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, 3)
