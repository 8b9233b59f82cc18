#: description = "The pedestrian reels across the road slowly, swaying from side to side."
#: rephrasings = [
#:   "Someone the worse for drink lurches over at a snail's pace, all over the place.",
#:   "The intoxicated pedestrian staggered slowly across the roadway.",
#:   "drunk ped, slow, swaying over",
#:   "The target follows a sinuous crossing path at 1 m/s.",
#:   "The man has drunken too much and goes slowly left and right over the street.",
#:   "A dizzy old gentleman totters across, drifting this way and that.",
#:   "He wavers over the tarmac step by unsteady step.",
#:   "A toddler waddles over with many a detour.",
#:   "some drunk was swaying his way over the road at a snail's pace, left a bit, right a bit",
#:   "The intoxicated subject slowly made his way over the street, swaying from side to side.",
#:   "Ped, drunk?, slow, lurching L/R while X-ing.",
#:   "The pedestrian target crosses at low speed with a superimposed lateral oscillation.",
#:   "A drunk man comes slow over the street, he moves like a ship, here and there.",
#:   "Slow crosser with sinusoidal path, v around 0.7 m/s, rocking to the sides all the way over.",
#:   "He rolled like a sailor as he came over, a little this way, a little that, and it took him an age.",
#:   "He's had a skinful, that one, he's rocking about and getting nowhere fast, give him time to get over.",
#:   "some wasted dude swaying across the road in slow motion",
#:   "A reveller rolled from side to side as he made a very slow passage over the street",
#:   "He swayed, he drifted, and he took an age to get over, is that what you saw?",
#:   "One drunkard crossing very slowly, this side that side, legs not listening to him",
#:   "Skinful on board, this one, two steps left, one step right, and all at the pace of a glacier",
#:   "Slow pedestrian crossing with pronounced lateral sway",
#:   "Drunk guy takes FOREVER swaying across the street",
#:   "The tippler wallowed sluggishly over.",
#:   "Unsteady man crosses at a creep, tilting left, then right.",
#:   "Slow reeler on foot, over the road in lurches from side to side.",
#:   "He traverse very slowly and balance himself to left, to right, always.",
#:   "Crossing pedestrian, low speed, rolling gait, no straight line, ego waits.",
#:   "Wobbly old woman, ever so slowly over our road, lurching sideways.",
#:   "A man with a bottle took the best part of a minute to get over in front of the taxi, listing to one side and then the other.",
#:   "Could you have somebody cross before the AV at a tottering pace, never in a straight line but lurching now to the left, now to the right?",
#:   "She was making her way over the street in slow motion and, being ill as it turned out, kept swinging from one side to the other.",
#:   "The pedestrian's crossing velocity did not exceed 0.7 m/s; the path exhibited alternating deviations to the left and to the right of the perpendicular.",
#:   "Mind the gentleman who's come out of the pub: he's on his way over, bit by bit, tacking like a dinghy, so hang back until he's landed.",
#:   "Slowly, terribly slowly, like a mast in a swell leaning to port and to starboard, the figure in the raincoat came over the road before us.",
#:   "Officer, I'd have hooted, only it wouldn't have helped. The fellow was crossing as though the ground were a ship's deck, over to this side, over to that side, and he moved forward so little with each step that I turned my engine off and waited.",
#:   "V1 approached an uncontrolled location. A pedestrian with a blood alcohol level of 0.21 was walking across V1's lane at a rate well below normal. The pedestrian swayed from left to right repeatedly, so that the driver of V1 was unable to judge on which side to pass.",
#:   "Our dog walks straighter than that man did. Daddy stopped the car and we all watched him come over. He went a bit this way and a bit that way, like when you've been spinning, and he was so slow that I could count to forty.",
#:   "Four in the morning, last load, and there's a lass in heels trying to get to the other pavement. She's weaving like a bee over a flower bed, left, right, left, and she's not getting there any faster than my wagon would on foot. I just sat and waited.",
#:   "We classify such persons as slow lateral oscillators: they traverse the carriageway at far below the usual walking speed, and superimposed on this is a body sway which carries the track alternately to either side. A constant-velocity model predicts neither the duration of the crossing nor its course.",
#:   "Over the road he sways, left, right, at a tortoise's pace.",
#:   "Ever so slow crosser, lurching now one way, now the other.",
#:   "drunk lady meanders across, slooow, tilting side to side",
#:   "An old man with a sack on his shoulder came over in front of us by slow, rolling steps, a bit to the left, a bit to the right.",
#:   "Bro took like a full minute to cross in front of my car, and he was swaying the whole way like there was music on",
#:   "The pedestrian's forward speed across the carriageway is set very low, and its heading alternates by a fixed angle to either side of the crossing direction.",
#:   "Leave him be, he's not well, he's reeling his way over bit by bit, he leans left, he leans right, and you'll simply wait till he's there.",
#:   "One man full of toddy was crossing, and his speed was like ant, also he was going little right side, little left side, never straight.",
#:   "Simulate a person who takes an age to get over the ego's lane and, all the while, keeps rocking off course to one side and then the other.",
#:   "I thought that it was the heat, it shimmers so on that stretch. It wasn't the heat, it was the man. He was on his way from the bar on the left to the bar on the right, the gap in front of our bonnet was all he had to get over, and with his swinging out this way and that he spent longer on it than on either drink.",
#:   "It is noted that the pedestrian was found to suffer from a disorder of the inner ear. He was crossing before the claimant's car at a speed well short of normal walking pace. His body and, with it, his course inclined by turns to the left and to the right, so that the claimant didn't dare to pass on either side.",
#:   "The bakery opens at five, and that's when the last of the wedding went home. She'd her shoes in her hand. She set out for our side of the street in the headlamps of the milk van, curving to one side, catching herself and curving to the other, and I'd taken two trays out of the oven before she had made it.",
#:   "Two measures characterise the track. Mean progress over the carriageway is 0.6 m/s, a third of the usual figure; and the heading oscillates about the perpendicular with a half-period of roughly one second. The ego, if it extrapolates from any one instant, believes that the pedestrian will walk to the left, or else to the right, of where he'll in fact be.",
#:   "He was carrying a wardrobe mirror, poor beggar, on a windy day. It would catch a gust and take him off to the left, and he'd haul it round and be taken off to the right, and in between there'd be half a step towards the far kerb. I'd got a load of fish on and I sat there and watched it warm up.",
#:   "N1 was observed by the driver of V1 at a distance of ninety feet. N1 was traversing the roadway from west to east at an unusually slow rate. N1's path wandered to the north and to the south in alternation throughout; the driver of V1 stopped and remained stopped until N1 had reached the east curb.",
#:   "Have you seen a duckling in long grass? That's the way our little one went over the drive at the campsite with her nappy down, and a camper van coming. Waddle and tip to one side, waddle and tip to the other, and so little headway that the driver cut his engine and got his camera out.",
#:   "Message from the safety driver: we're fine, we're only waiting. There's a gent ahead who's got it into his head to cross. He's listing to port, he's listing to starboard, and between the two he's making about a foot a go, so don't expect us at the depot before dark.",
#:   "In the night in Köln, at carnival, comes a clown on the street before my taxi. He'll go to the other side, but his shoes will go everywhere, to left, to right, to left. And so slow he does it that my passenger says: turn off the meter.",
#:   "The distance was seven metres, and it took him the whole of the second verse. He sang as he came over, and he leaned with the tune, down to the one hand on the low notes and down to the other on the high. Her motor idled, her wipers beat, and little by little the singer drew near to the farther kerb.",
#:   "I've had more patience since I took up cycling. So I put a foot down behind the hatchback and we both watched this patient in a dressing gown get himself over to the clinic. You know a pendulum, how it goes to this side and that side and the clock hardly seems to move on; well, he was the pendulum and the clock.",
#:   "Bit left, bit right, bit forward: a minute for one lane.",
#:   "He lists, he rights, he lists, inching over before us.",
#:   "Swaying crosser, glacial, never once on a straight line.",
#:   "The crossing gentleman had swayed nine times to the left and eight to the right, and still he had a yard of our lane to get over.",
#:   "Crossing pedestrian with very low speed; heading to alternate by a fixed angle to each side of the perpendicular every 1.2 s, until the road has been crossed.",
#:   "guy crossing in front of me is basically a screensaver. drifts left, bounces, drifts right, bounces, gains an inch each time. im on episode 2",
#:   "Toddy was in him or he was in toddy: now this side leaning, now that side leaning, and so slow the road he's passing that my tea became cold.",
#:   "The dotted line of her footprints in the snow runs over the lane in ripples, left and right, and the prints are so close that each touches the next.",
#:   "Let him finish; he's making for the far kerb, but reeling now this way, now that, and it'll be a long while before he's over.",
#:   "I turned my lights off so as not to hurry him, which wasn't a danger. His hat was what I went by. It hung over my left wing; it swung over to my right wing; it swung back, and each time I could've sworn that it'd not got any nearer to the pub on the far side. But it must have, for in the end it went in.",
#:   "The predicted path of this pedestrian fans out like a hand of cards. Seen at an even second he's bound for the front of our car, seen at an odd one for the rear, since his body tips to one side and to the other. What all the cards have in common is that he's hardly advancing; thirty seconds for the lane, and the ego waits for them all.",
#:   "The bride's mother had a tray with glasses on it. The marquee was on one side of the lane and the kitchen on the other. The glasses slid left and she went left after them, they slid right, so did she, and in between there'd be one small step for the kitchen. We'd the windows down and were holding our breath, with the engine off.",
#:   "Witness: I was the second vehicle. I couldn't see why the hearse in front of me had stopped, as there wasn't anybody before it. Then there was somebody, leaning out past its left lamp; then nobody; then somebody past its right lamp, the same man. He was on his way over from the Legion, sir. I'd say it was three or four minutes before he'd left the road.",
#:   "A boat that goes about and about against the wind makes headway in the end, and so would he, I told my pupil. He's on his starboard tack, he's showing us his left shoulder; now he's come about. What you've to look at is how much he has gained, and it's half a metre. So, handbrake on, neutral, and let the gentleman beat his way to the other shore.",
#:   "My sister, a nurse, calls it the tray of drinks. They come over the road in front of you as if on top of their head were one, and it's sliding. This fellow had it badly. He'd go with it one way, he'd catch it, he'd go with it the other, and the road he'd meant to get across went by beneath him at the speed of a minute hand.",
#:   "Vehicle 1 was halted for a pedestrian, P1, and was struck from the rear. P1's position was noted from the dash video at five-second intervals. The lateral figures read two feet north, two feet south, three north, two south. The forward ones, that is, across the road, increase by no more than three feet at a time; after forty seconds P1 was in the gutter on the far side.",
#:   "I drive off ferries, but this chap was on dry land. He'd the legs for a gale. He came out from the quay side and over my road as though it was heaving; down he'd go to port, hang there, down to starboard. You couldn't have hurried him with a gun, and I'd the last boat to catch.",
#:   "I write from the sixth floor where all night I can see the street. There come two lamps of a taxi and they stand. Before the lamps there's a small man with a long shadow, and the shadow goes like the windscreen wiper, left, right, left, right. I've made a coffee. I return, the shadow wipes still, the man's by now in the other half of the street.",
#:   "I'm four and I can do it as well, look. You put your arms out and you go ooh over that way and then you go ooh over this way, and you only do little, little steps. The man did it on the road where our car was waiting. It took very long. He got to the other side and I said can he do it again.",
#:   "One says of such a man that he has had too much; she thought that, rather, something had been taken out, the keel. There was nothing to hold him. He leaned on the left half of the night till it gave, and then on the right; it gave too. And so, between the two of them, by handbreadths, he was let across before her lamps to the other side.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "weave", "slow"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 0.95
#: high = 1.35
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 6.0
#: high = 34.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_ADV_ANGLE"
#: low = 0.6
#: high = 0.9
#: unit = "rad"
#: meaning = "how far each leg slants"

param OPT_ADV_SPEED = Range(0.95, 1.35)
param OPT_ADV_DISTANCE = Range(6, 34)
param OPT_ADV_ANGLE = Range(0.6, 0.9)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 3.5
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE) for 0.6 seconds
    while True:
        do MoveAhead(globalParameters.OPT_ADV_SPEED, -2 * globalParameters.OPT_ADV_ANGLE) for 1.2 seconds
        do MoveAhead(globalParameters.OPT_ADV_SPEED, 2 * globalParameters.OPT_ADV_ANGLE) for 1.2 seconds
