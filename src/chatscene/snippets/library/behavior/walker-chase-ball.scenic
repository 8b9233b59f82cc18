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
