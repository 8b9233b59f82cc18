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
