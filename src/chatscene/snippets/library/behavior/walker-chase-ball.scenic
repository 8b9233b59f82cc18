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
