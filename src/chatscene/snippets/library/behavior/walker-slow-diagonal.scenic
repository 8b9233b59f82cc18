#: description = "The pedestrian shuffles across slowly on a long diagonal."
#: rephrasings = [
#:   "The old fellow takes his sweet time and goes over on the slant.",
#:   "An elderly pedestrian was crossing the roadway slowly and at an oblique angle.",
#:   "slow ped, diagonal path",
#:   "The adult target crosses obliquely at 1 m/s.",
#:   "The grandmother goes slowly and not straight over the road.",
#:   "A tired walker drags herself over the lane in a drawn-out oblique line.",
#:   "Someone on crutches makes for the far pavement the long way, at an angle.",
#:   "He dodders slantwise through our lane as though he had all day.",
#:   "an old dear was shuffling over on a slant, taking the longest way she could find",
#:   "An elderly pedestrian slowly crossed the street on a long angle rather than directly.",
#:   "Ped: slow, slantwise, long way over.",
#:   "The elderly pedestrian target crosses at 2 km/h on an extended oblique path.",
#:   "One old man goes slantwise over the street, very slow, his feet do not leave the ground.",
#:   "Slow skewed crosser, shallow angle to the lane, long exposure time in front of the SUT.",
#:   "She dragged her slippers over the road at so shallow a slant that it seemed she would never get to the end of it.",
#:   "He's not coming straight over, he's cutting right along the road at an angle, and at that pace you'll be here a while.",
#:   "old man crossing the longest way possible on a diagonal sooo slowly",
#:   "A frail resident made her slow way over the street aslant, taking twice the distance",
#:   "The deceased crossed not squarely but at a long slant, and with very small steps?",
#:   "Ah ma crossing slant slant, slowly slowly, we wait until neck long",
#:   "Corner to corner he's going, slippers and all, I could've done the crossword",
#:   "Slow oblique pedestrian crossing with extended exposure time",
#:   "Grandma takes the LONG diagonal in slow motion",
#:   "The old man inched slantwise over.",
#:   "Granny toddles over the road slantwise, in no hurry whatsoever.",
#:   "Someone ambling across obliquely, taking ages about it.",
#:   "Let a man with a stick hobble over on a long diagonal.",
#:   "Slow crosser, skewed path, stays before the AV forever.",
#:   "Toddler-paced walker traverses the street at a shallow angle.",
#:   "With her two sticks she inched over, and since she went cornerwise rather than straight, I switched off the engine and waited.",
#:   "The old man needs a half eternity, because he goes with very little steps and not direct over the street but in oblique.",
#:   "The mannequin travels at 0.6 m/s on a straight line inclined at forty-five degrees to the road axis, from one edge to the other.",
#:   "He's plodding across to the post office, on a slant, so he's got twice as much road to cover at half the speed.",
#:   "Have you ever seen anyone so leisurely, drifting from this corner to that one as though the street were a village green?",
#:   "Please produce a woman with a pram who dawdles over my lane, and whose way is angled so that she's long in front of me.",
#:   "The gentleman set out by the butcher's and was aiming for the bank, which is a good way up on the other side. He tottered there in one long slanting line, and it took him the whole of the news on the radio.",
#:   "V1's video depicts the pedestrian, aged 84, moving at a shuffling gait from the northeast corner toward a point well down the opposite curb. Owing to the angle and the low walking speed, she was in the lane for eleven seconds.",
#:   "Two blocks from the clinic a man with his leg in plaster came off the pavement. Clump by clump he made his way over, not square to the kerb but slanting along the street, and we in the queue could only admire him.",
#:   "Our object predictor assumes that people take the shortest path at about one and a half metres per second. This pedestrian does neither, trudging over at a third of that and on a bearing which runs half along the lane.",
#:   "My neighbour Mr. Wu is ninety and his feet don't lift. Every morning he goes over the road to buy bun, not straight, slant from our gate to the shop far there, and all cars must look at him long time.",
#:   "Slow as treacle, and slantwise too, the old boy took our road.",
#:   "Creeping over on a long skew, corner to far corner.",
#:   "Shuffler, oblique line, over the lane, ages.",
#:   "I'd like a grandmother with a shopping trolley who makes her way over at a creep, in a line leaning far up the street.",
#:   "From the post box on this side to the bench on that one, forty paces on, he drew the longest and slowest straight line of his life.",
#:   "Old pedestrian he is walking so slow like counting coins, and not straight over, he goes in the slope till the far tree.",
#:   "Pedestrian speed 0.5 m/s, heading 35 degrees to the lane axis, path constant; occupancy of the ego's lane exceeded fourteen seconds.",
#:   "Doesn't that lady know that the shortest way is straight over, if every step costs her as much as it seems to?",
#:   "Caller says a man on a walking frame is making his way over the A6 at an angle, dead slow, and traffic's having to wait for him.",
#:   "The light had time to change twice. We hadn't got a red, understand, the shuttle had stopped for a priest, of the very ancient sort, who had set off from the presbytery and was bound for the church gate, well down on the opposite side. He took the direct line between the two. He took it in carpet slippers.",
#:   "My son asked if the man was a statue. He wasn't, you could see it by the drainpipe behind him, which he had left by about the width of a hand. His nose was pointed at the tobacconist's, so more along the street than over it, and thither, half a shoe at a time, he was on his way, in front of all of us.",
#:   "As a witness I can give you times. At ten past he stepped off by the fountain. At eleven minutes past he was in the lane of the red car, which had stopped, and abreast of the bakery. At twelve past he'd reached the bank. So it's twenty-odd metres along and eight over, in two minutes, and straight as a ruler.",
#:   "There's slow and there's Mrs Pugh. When she goes over to her sister's she doesn't go over, she goes along and over together, since the sister's three doors up. You could boil an egg. So I pull the handbrake, open my flask, and watch her slide from my left headlamp to my right with her casserole.",
#:   "The patience module stands or falls with this. A pedestrian, frail, steps in ahead and proceeds at less than half a metre per second on a path which isn't perpendicular but slopes heavily along the road. Every two seconds the AV believes that the lane's about to be clear. It isn't. She's farther over, yes, and farther along.",
#:   "I got off and pushed, out of politeness. In front of me a car was waiting, and what it waited for was a monk, under a load of firewood. You'd say he was measuring the road. Foot, other foot, foot; and each a bit over and a good bit forward, from the low corner to the high one, never in a hurry.",
#:   "V1 came to a controlled stop for an elderly male, who'd entered the roadway some sixty feet ahead. The male's path was diagonal, toward a bus shelter further down the opposite curb. His pace was described by one witness as \"glacial\". V1 remained halted for 26 seconds, at which time it was struck in the rear by V2.",
#:   "In the theatre we'd say he crosses upstage. He comes down from the pavement, left, he's bound for the far exit, right, at the back. He has gout. So the whole width and half the depth of the street are gone over on one slanting line, with tiny steps, while a taxi without a driver waits like an understudy.",
#:   "You'll want to go round him. Don't. Because he isn't walking across, he's walking across and away at once, towards the bowls club, and on those feet he'll be needing your lane for a good while. If you go to his left, he's there in ten seconds. If you go right, he's there now. Neutral. Breathe.",
#:   "My grandfather crosses our street like he's writing Chinese, very slow, one long stroke falling from right top to left bottom. He starts at the noodle shop. He ends at the clock repair man, six shops down. Cars stop, drivers take out the phone. When the stroke is done he bows a little and they can go.",
#:   "i timed it. lady w two sticks, comes off the kerb at the crossing by lidl but doesnt use the crossing, heads off at an angle to the taxi rank, 1 min 14 to do one lane. nobody beeped which was nice tbh",
#:   "Slippers, a slant, and all the time in the world.",
#:   "He inched from our corner to the furthest one.",
#:   "Dawdling over on the bias, bag by bag.",
#:   "As the shop he wanted was well up the other side, and as his knees were what they were, we had him ahead of us, at an angle, for a full minute.",
#:   "The lady had gone over only a metre when she had gone along three, and neither figure, I can assure the court, had been arrived at in any haste.",
#:   "Let a man with a frame make for a point twenty metres up the opposite kerb at half a metre per second, so that the lane stays taken.",
#:   "With little steps like a hen she goes over the street, not direct, along the long slope, and my engine I could have repaired in the meantime.",
#:   "Unit two, be aware we've a gentleman in a dressing gown, crossing cornerwise by the clinic, going very slow, he'll be in your lane a good while yet.",
#:   "How do you get past somebody who's neither walking along your road nor straight over it, but doing a bit of both, and at a creep?",
#:   "There's a knitting shop and there's a tea room. If you lay a ruler from the one to the other it'll lie on the road for most of its length, and at the height of my bonnet that afternoon there moved along the ruler's edge, a stitch at a time, my old headmistress. I got through two pages of the paper.",
#:   "The queue was eleven cars long when I joined it and nineteen when I found out why. A man was taking a tortoise for a walk, or possibly the other way about. They weren't crossing square, since neither of them had thought of it. They were on their way from the bottom gate to the top one, slantwise, at the tortoise's best.",
#:   "It's a test of nerves, and it's the planner's nerves we're after. The figure in front never stops, so you cannot call it an obstacle; it's nearer the far kerb at every glance, so you might think it's finished. But it creeps, and its line's so flat to the road that at each glance it is also farther up. Our car edged forward eleven times.",
#:   "I've a photograph at either end, I was that bored. In the first one she's by the bin on my side with her two carriers. In the second, by the clock, it's a minute and fifty seconds later, and she's reached the opposite kerb at the bus stop, which is five houses on. You can join the two with a straight line and there you have it.",
#:   "First the stick, then the left foot, then the right foot up to it. This makes thirty centimetres. He wants to the tobacco shop, and the tobacco shop is not across, it's across and up. My bus has waited here in 2009 already for the same monsieur. He's got slower. But his oblique line, nobody has been able to take from him.",
#:   "On the pavement they'd laid a trail of sawdust for the parade, and Mr Ojo followed it. It led from kerb to kerb, as a sash does from shoulder to hip. He had his oxygen with him. Nobody hooted; the fire engine switched off its lamp; and he hauled the little trolley along the sash, pausing at nothing, hurrying for no one, until he'd come to the hip.",
#:   "Why aren't we going, you ask, when there's clearly space to go? There's space behind her. There'll be space ahead of her when the cows come home. She's heading for the church, which is right down there, and she's taking it corner to corner, at the pace of her bad hip. Anywhere you point the car, dear, she's been or she's bound.",
#:   "V1 was stationary for 31 seconds. During this time a pedestrian using two canes traveled from the southwest curb, abreast of V1, to a driveway on the northeast side approximately 60 feet distant. Video shows a uniform shuffling gait and a straight path, skewed by some 60 degrees. V4's operator, unaware of the reason for the delay, attempted to pass.",
#:   "As an ex-surveyor I appreciated it. He'd taken a bearing on the Red Lion, a good chain and a half along on the other side, and never deviated from it by a foot. It's just that he covered the ground as a shadow covers a lawn. By the time he had my near wheel abeam I had written to my sister; at my off wheel, I'd stamped it.",
#:   "Snow had been falling since noon, and the woman who went by in front of their lamps left two furrows in it, for her feet did not come up. The furrows began at the well. They leaned so far along the street that they were longer than it was wide by half again; and at the end of them, black, hardly moving, bent, she was still making them.",
#:   "taxi (the one w no driver) waiting for a dude with like six pizza boxes up to his eyes. hes feeling his way over with his toes. not even going straight over, hes aiming for a door way down the block so its this endless slow diagonal. someone played the mission impossible theme",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "diagonal", "slow"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 0.7
#: high = 1.2
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 8.0
#: high = 34.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_ADV_ANGLE"
#: low = 0.45
#: high = 0.85
#: unit = "rad"
#: meaning = "how far its way turns from straight across"

param OPT_ADV_SPEED = Range(0.7, 1.2)
param OPT_ADV_DISTANCE = Range(8, 34)
param OPT_ADV_ANGLE = Range(0.45, 0.85)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 3.5
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE if offsetFrom(egoRoute, self) > 0 else -globalParameters.OPT_ADV_ANGLE)
