#: description = "The pedestrian runs after a ball into the road and follows it along the lane."
#: rephrasings = [
#:   "A ball rolls out and the little one comes flying after it, down the road ahead of us.",
#:   "A child ran into the roadway in pursuit of a ball and continued along the lane of travel.",
#:   "kid chases ball into lane, runs on along it",
#:   "The child target enters at running speed and then changes course along the VUT's lane.",
#:   "The kid is running behind the ball on the street and then along with it.",
#:   "A boy hares after his football, which the camber carries away from us.",
#:   "Somebody sprints after a hat the wind blows down the lane.",
#:   "The dog owner tears into the road and veers off after the runaway pet.",
#:   "a nipper came belting out after his football and went chasing it down the lane",
#:   "A juvenile ran into the street in pursuit of a ball and continued after it along the traffic lane.",
#:   "Kid after ball: out into rd, then along lane w/ it.",
#:   "The child target runs into the carriageway and then changes direction, following a rolling ball along the lane.",
#:   "The child runs behind his ball in the street, and then along the street where the ball goes.",
#:   "Ball-chasing kid: run in from the side, then curve to run lengthways down our lane; ball itself need not be modelled.",
#:   "The girl had eyes for nothing but her ball; out she flew after it and along the road as it bounced away.",
#:   "Ball! And where there's a ball there's a child, here he comes, and he's off down the lane after it.",
#:   "little kid ran out after his football and kept running up the road after it",
#:   "A seven-year-old dashed from the park after a runaway ball and pursued it up the carriageway",
#:   "The child followed the ball into the road and, as it rolled along, so did she?",
#:   "Small boy running behind ball, came on road, then running along the road itself behind it",
#:   "Ball bounces out, and you know what follows a ball: a nipper, legging it up my lane after it",
#:   "Ball-pursuing pedestrian entering the road and continuing lengthwise in lane",
#:   "Kid chases ball onto road and KEEPS GOING",
#:   "The toddler scampered after the ball and up our lane.",
#:   "Kid's after his football, in the lane now, heading along it, brake!",
#:   "Stray ball, small girl in hot pursuit, out and then down our lane.",
#:   "Make a child rush out behind a ball and trail it up the lane.",
#:   "Der Ball rolls in the street, the boy runs after, and then längs with it.",
#:   "my little bro chased his ball into the street and kept going along it",
#:   "The ball had the better of her, bouncing on down the lane, and the schoolgirl who'd sprinted off the pavement to fetch it went haring along in its wake.",
#:   "The child dummy enters from the kerb at running speed, then alters heading so as to travel lengthways in the VUT's lane, as though pursuing a ball.",
#:   "Don't look at the ball, look at the lad running out for it; see, he's turned with it and he's pelting up the lane in front of you.",
#:   "Because the street slopes, the football didn't cross but went rolling along, and so did the teenager who'd rushed into the road to get it back.",
#:   "A young boy was seen running up the middle of the lane ahead of Vehicle 1, having left the sidewalk in chase of a basketball.",
#:   "Was the child not so taken up with her ball that she ran into the road for it and thereafter pursued it along your lane?",
#:   "My grandson slipped my hand, and I shall never forgive myself. His new red ball had gone off the pavement, and he flew after it into the street. It wouldn't lie still, the wind had got it, so the pair of them went off along the lane, ball first, before that poor man's car.",
#:   "For the play-street scenario I want a youngster who comes running into the road from the side. They should not go over to the other pavement: a ball is leading them on, so once in our lane they change direction and run the same way we're driving, right ahead of the bonnet.",
#:   "From my cab I saw a tennis ball, then a bloke in shorts, who must've been forty and should've known better. Out he came at a run, missed it with his foot, and as it trickled on down the lane he went galloping after it, bent double, with me on the brakes at his back.",
#:   "The cricket ball had been hit for four, it seems, and the fielder had no time to consider the traffic. He was over the low wall and in the road at a sprint; then, the ball having taken a turn along the tarmac, he too took a turn and raced away up the lane in front of us.",
#:   "Robotaxi log, residential zone: pedestrian, short stature, fast entry from nearside following a small round object. The track then bends through some seventy degrees and continues parallel to the lane, ahead of ego, still running. The predictor had bet everything on a straight crossing and was surprised by the change of course.",
#:   "Ball, then boy, full speed off the kerb, both off up our lane.",
#:   "Girl tears out after her netball and stays on its tail, lane-wise.",
#:   "the ball rolls away down the lane n the kid just sprints behind it",
#:   "Downhill went the beach ball, keeping to our lane, and downhill behind it, as fast as flip-flops allow, went the father who'd darted out to save it.",
#:   "Pedestrian trajectory: rapid lateral entry from the roadside, then a bend into the direction of travel of the VUT, consistent with pursuit of a rolling object.",
#:   "Where a ball goes is where its owner goes, so when it hopped off the pavement and trickled away along our lane there was soon a running boy between us.",
#:   "Make the child hurry into the road on account of a ball and, the ball having been deflected, hurry after it lengthwise down the ego's own lane.",
#:   "Der Kleine comes out like an arrow because of the football, it rolls away before us in our lane, and so we see him running only from behind.",
#:   "\"She won't leave that ball,\" I said, and sure enough she flew off the grass into the road and was soon pelting along it, pigtails to us, hard behind.",
#:   "I'd seen the ball, so I'd already braked. It bounced once and settled into the gutter of the tramline, where it ran along in front of me like a little train. The lad who burst out between the cars had a choice then, over or along. He went along. I had the back of his shirt in my windscreen, number 10, for half the street.",
#:   "Pursuit of a runaway basketball was the reason given by the youth. He had hurdled the playground fence, he said, and was on the roadway before he thought. As the ball did not lie still but went on up the lane, so did he, at a run, and it was while he was so running that V1 approached him from the rear.",
#:   "It's the wind you want to blame. My red ball wanted to go to the other side, and I ran out quick to help it. Then the wind came and it wanted to go up the road instead. So I ran that way too, on the road, and behind me there was a car with a very loud horn.",
#:   "The defence says that no one could foresee it. A ball emerges. It does not cross the road; it goes off along my client's lane, with the slope. A child then emerges, running. If the first rule is that children follow balls, the second is that they follow them wherever they go, and this one ran up the lane ahead of my client's bonnet.",
#:   "So we're in the back of one of these robotaxis, chatting, and it slows right down. A woman in a tracksuit had come belting out of the park after a football. Mum of the goalie, I think. It wouldn't wait for her. There's the ball, there's her, there's us, all in a line, all in the same lane, all heading for the station.",
#:   "The track initiates at the nearside boundary, at running speed and perpendicular to us. Three hundred milliseconds on, it has rotated by about two thirds of a right angle. From there its heading and ours differ by next to nothing. It's a person running in front of us in our own lane, and the white blob further up is what they're after.",
#:   "Forty years of cricket on that green and not one broken headlamp. The boy Evans had misjudged it, that's all. He'd leapt the rope, eyes on the ball, and he was in the road going full tilt before it occurred to him that it was the road. The ball had gone left up the lane by then. He went left up the lane with it.",
#:   "Gently off the gas, and tell me what's going to happen. A ball's come out, good. Who comes with it? There, a little lass, running. Which way will she go? No, not to her friends on the other pavement, look at the ball, it's off down our lane. And so's she. We'll stay well back until one catches the other.",
#:   "They were a procession, really. In the lead was the orange, for it was an orange and not a ball, but the little boy made no distinction. He had been quicker off the kerb than his nurse could clutch. The orange rolled on along the crown of our lane; the boy, in full cry, ran on along it after; and after the boy crept we.",
#:   "My complaint's with the council and not the teenager. That gully takes anything round and shoots it along the lane. I've a lorry that stops in its own length, thank God, so when he came out like a whippet for his ball, and then didn't cross but turned and raced up the road with it ahead of my cab, I'd room.",
#:   "The bell of my bicycle is useless against the football fever. One boy, he is jumping from the pavement with fast legs, the ball is in front of his foot but never at his foot. It's running along the lane, he's running along the lane, the van behind him is running along the lane, and I'm singing at all of them.",
#:   "Beach ball, then a lad, pelting away up our lane after it.",
#:   "kid flies out after ball n now BOTH r going down my lane",
#:   "Child off the kerb for a football; now it's legging up your lane.",
#:   "The little red ball had turned along the road, and so had the little red boots, which had come off the pavement at the double and were drumming away before our bumper.",
#:   "We braked as for a crossing, but it wasn't over the road the girl was going; where the tennis ball bounced down our lane was where she raced.",
#:   "I saw her profile as she flew off the footpath, and from then on only her plaits, because the ball was running up the lane ahead of us and she with it.",
#:   "The child target enters from the side at running speed and, once in the lane, takes the heading of the ego, representing pursuit of a ball that rolls lengthwise.",
#:   "First the basketball, it's always first; next the boy, running, from your left; and don't think he'll go over, he's off along the lane in front of you behind it.",
#:   "Have a youngster tear into the road after a runaway ball and, since it trundles off in the direction we're driving in, tear along our lane after it.",
#:   "I had to follow a nine-year-old's back for thirty yards. You'll say, how did it get there? Like a shot, from the gate of number 4, at right angles to me, and I was going to pass behind. Only his football had hit the far kerb, come off it and gone bowling away down my lane. His feet did what it did.",
#:   "Heading of the track, relative to ours: ninety degrees until it is in the lane, about zero after that. Speed: that of a child at full run, before and after. Object 2, thirty centimetres across, has the same course and is two metres further on. It's object 2 that explains object 1. Braking must go on for as long as both are in front of us.",
#:   "She never once looked round, that's what made the hair stand up on my neck. I could've touched her satchel with the bumper. She'd been a yell and a flash of blue from the left, hard on the heels of something yellow, and then the yellow thing was hopping off down my lane, hop, hop, and there was the satchel jumping in front of me, hop, hop, behind it.",
#:   "Why we had stopped the bus and started again and stopped again I couldn't see from the rear. The lady in front said it was a game. A big lad had dashed into the road for a rugby ball. You can't know with them which way they'll bounce. It had bounced away from us, along the road, twice, and twice he'd been about to have it and gone haring on.",
#:   "En el barrio the ball is sacred. It goes out of the plaza and the smallest must go. So he goes, as an arrow, to the street, and the street has a slope, that direction I drive too. The ball takes the slope. He takes the slope. I take the slope, with my foot on the brake, behind one kid and one ball, in procession.",
#:   "For those who say she should've been on the other side in a second: look at the gradient. The ball came off the playground on to the road and there it fell in with the gutterless camber of lane one and went south, as the claimant was going. So did my daughter. She'd run out; she ran on. Her shoe marks, fourteen metres of them, are all in lane one.",
#:   "Headline writers love a hero, so here's ours: the driver of the 8.15, who crept along Park Road with his hazards on. Before him ran a boy called Sam. Before Sam bowled a match ball. The two had come over the wall and into the road in the wrong order, ball and then Sam, at a fearful lick, and only the drain by the school put a stop to it.",
#:   "Tell me what you see. \"A dog toy. A ball, sir, in our lane. It's rolling away from us.\" And? \"And there's nobody.\" Wait. \"There's somebody!\" Somebody, from between the vans, as quick as she can go. Does she want the other pavement? No, lad. She wants what's rolling. So she's now in front of you with her back to you, running, and that's why I had you off the gas.",
#:   "For the fleet bulletin. It isn't enough to stop the wheels from meeting the child at the place it comes out at. Ours came out, at a run, two car lengths in front. Had it kept to its line it'd have been clear. It gave up its line, as its ball had done, and took ours; and it was doing eight miles an hour on it when we were doing twenty.",
#:   "There was the sound of a ball on a road, which is the loneliest in the world, and it went from us. Past the parson's lamps came a small boy in a nightshirt, sidelong and headlong, and one waited for him to vanish into the dark across the way. He grew smaller and smaller instead in the middle of the beam, bare heels twinkling, after the sound.",
#:   "In the zombie level it's the kid with the ball that gets everyone. You know to brake when the ball rolls in. You brake, kid sprints in from the side, you think okay, he despawns over there. Nope. The ball's physics take it up your lane, so he hooks ninety degrees and sprints up your lane as well, right in front, so if you've let go of the brake it's game over.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "fast", "swerve"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.4
#: high = 5.5
#: unit = "m/s"
#: meaning = "how fast it runs"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 14.0
#: unit = "m"
#: meaning = "how far the ego still has to go when the adversary reaches its line"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 0.3
#: high = 1.2
#: unit = "m"
#: meaning = "how far from the ego's line it turns along the road"
#: [[parameters]]
#: name = "OPT_ADV_ANGLE"
#: low = 1.0
#: high = 1.4
#: unit = "rad"
#: meaning = "how far it turns along the road"

param OPT_ADV_SPEED = Range(3.4, 5.5)
param OPT_ADV_DISTANCE = Range(0, 14)
param OPT_ADV_REACH = Range(0.3, 1.2)
param OPT_ADV_ANGLE = Range(1, 1.4)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    # With the ego's direction, from whichever side it comes.
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE if offsetFrom(egoRoute, self) > 0 else -globalParameters.OPT_ADV_ANGLE)
