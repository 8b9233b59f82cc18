#: description = "The pedestrian crosses the road diagonally, slanting along it."
#: rephrasings = [
#:   "A person walks over the carriageway at a slant rather than straight across.",
#:   "The pedestrian takes an oblique line through the lane ahead of the ego.",
#:   "A jaywalker cuts the road at an angle.",
#:   "Someone wanders across on a long diagonal, with their back to the ego.",
#:   "The cyclist drifts over the street slantwise.",
#:   "He takes the lazy slanted shortcut over the road in front of us.",
#:   "The pedestrian crossed the roadway at an angle rather than perpendicular to traffic.",
#:   "ped crosses obliquely, same heading as us",
#:   "He didn't go straight over, he cut across at a slant as if the road was a field.",
#:   "Pedestrian traversed the roadway at an angle rather than perpendicular to it.",
#:   "Ped x-ing oblique, half along road, half over.",
#:   "The pedestrian target follows a trajectory at approx. 45 degrees to the lane axis.",
#:   "The man walks over the road not straight but oblique, so it takes long.",
#:   "Crosser heading is skewed, moves with the lane as well as through it.",
#:   "She took the long line over, edging down the street and over it at one and the same time.",
#:   "That cyclist is cutting across on the angle, he'll be in your way longer than you think.",
#:   "he crossed like corner to corner instead of straight over, took forever",
#:   "A pedestrian took a slantwise course over the road, with the oncoming car gaining on him the while.",
#:   "The witness did not walk straight over, my lord; she bore away along the street as she went.",
#:   "Uncle crossing in slanting manner, not straight, so whole time he is in front of my vehicle.",
#:   "Never learnt to cross square, this one, he's going over like a bishop on a chessboard.",
#:   "Skewed crossing trajectory of vulnerable road user with extended exposure in the lane",
#:   "JAYWALKER TAKES THE HYPOTENUSE",
#:   "The cyclist angles across the street.",
#:   "Jogger goes over the road slantwise, gaining ground along it too.",
#:   "Make the cyclist traverse our street obliquely, not square.",
#:   "At a slant, up the road and over, goes the paper boy.",
#:   "Ped track crosses lane at 40° instead of 90°, constant walk.",
#:   "No right angles for granny: she crosses on the bias.",
#:   "A man with a rucksack left the bus stop and headed for the pub on a slanting line, so that he was travelling down the street while crossing it.",
#:   "Instead of taking the shortest way to the other kerb, the child walked a long oblique line over the carriageway ahead of our car.",
#:   "The VRU path shall form an acute angle with the lane direction, so the target advances along the road during the entire crossing.",
#:   "I need a scenario with a pedestrian whose way over the street is skewed: he aims for a doorway further along and walks directly to it across the tarmac.",
#:   "Mister is not crossing straight, he is crossing slant-wise towards the temple gate, that is why he was for long time before my auto.",
#:   "What makes it awkward is the angle; she doesn't step straight over, she drifts across and forward together, from this lamp post to that one down there.",
#:   "The postbox stood some way up on the opposite side, and that was where he was bound. He saw no need to walk up first and then over. He struck out across the road in one slanting line, with the traffic coming on at his shoulder.",
#:   "Pedestrian 2 departed the north sidewalk and walked on a southeasterly heading, that is, oblique to the travel lanes, reaching the south curb about fifty feet farther along. Because of that heading she was in the lane of Vehicle 1 for longer than a perpendicular crossing would take.",
#:   "Riding home I usually cut from the end of the cycle track to the opposite bike rack. It's a diagonal, I know, you go along the road as much as over it, and the robotaxi behind me had to wait until I was off its lane.",
#:   "This is the clip where the lad can't be bothered with corners. Watch his feet: he comes off the pavement and goes across at an angle, same direction as the cars more or less, and he gets to the other side three shopfronts further on.",
#:   "I say, officer, he went the way a ferry goes over a river, carried down while he was going over. From the chemist's on one side to the butcher's on the other, which is not opposite at all, and my lane was right in between.",
#:   "Askew over our road, shopping trolley and all, went Mrs Patel.",
#:   "Ped heading neither along nor square: something in between, through our lane.",
#:   "Have the boy with the skateboard walk our street corner-wise.",
#:   "She set her course for the far end of the block and took the road as part of the way, on a long slope rather than straight over.",
#:   "The target leaves the kerb at 40 degrees to the lane and retains that heading until the opposite kerb, thus covering lateral and longitudinal ground at once.",
#:   "In my village we go over the road like a knight in chess, no, like a bishop, so this uncle also did, before the truck.",
#:   "A cyclist making for a side road further up rode through our lane at a shallow angle, pedalling half with us and half across us.",
#:   "Because his bus was already loading thirty yards on, the man didn't walk straight over but aimed for it, and so his path sloped away ahead of the claimant's car.",
#:   "If you draw the lane as a ruler, the walker's track is a pencil line laid over it crooked, beginning near us and ending well down the page.",
#:   "He had left his umbrella open, and it was all I could see of him, a big striped disc. It began at the right-hand kerb by the bank. Then it kept getting both more to the left and further off, until it was folded up in front of the cinema, six doors along on the other side.",
#:   "V1 was approaching Oak Street. Pedestrian 1 stepped from the right curb near the hydrant and reached the left curb near the driveway of number 212, a point some sixty feet beyond. His track between those points was a straight one, per the snow, and did not follow the shortest way at any time.",
#:   "Oh it drives me potty on the bus. They get off at my front door, and the shops are over there and up a bit, so do they use the crossing, no. They head off on a slant with their backs to me and I have to creep after them until they've sloped off my side.",
#:   "The shadow gave it away first. It was late, the sun was low behind us, and a long thin shape lay over the tarmac. It belonged to a girl with a cello who was on her way to the music school, down the road on the opposite side, and her route there led obliquely over both lanes.",
#:   "Our AV overestimated the speed at which she'd clear. It took the velocity vector's length, 1.3 m/s, and forgot that more than half of it pointed down the street, away from us. So she stayed in the lane for six seconds, walking steadily on a bias to a shop that lay further along.",
#:   "As the witness put it, there was nothing hasty in his manner. He walked as one walks over a meadow, from the lime tree on this side to the well on that side, and these do not face one another. The road merely happened to lie between, and the defendant's car happened to be on it.",
#:   "On your own bike you know that trick, don't you, you don't want to lose your swing, so you don't cut square over, you let it run along and over in one. That's what the lady with the child seat did ahead of our car. Kerb to kerb took her half a street.",
#:   "Watch where a person's shoes are pointing, I tell my learners. This chap's shoes point neither at the other pavement nor up the road, they point at the pub sign over there, so that's how he'll go. And see, he's been in our lane twice as long as you reckoned with.",
#:   "If possible add one pedestrian that does not cross at right angle. He starts at right border when we are twenty-five metres before him, goes with constant step in a skew direction, away from us and to the left, and comes to left border maybe ten metres further than he has started.",
#:   "A kid's drawing, that's what the police sketch looked like. Two lines for the road, a box for me, and a third line running from bottom right to top left, with a stick man on it. I said yes, that's him, exactly so, he took the slanting way and I ran out of road.",
#:   "The shuttle's passengers later agreed on this much: the drunk wasn't swaying, in fact he held a beautiful straight line. Only it was the wrong line. It ran from the kebab shop to the taxi rank, and the rank's on the far side and four lamp posts up, so he was in their lane for the best part of it.",
#:   "He took the road cornerwise, from our kerb to one further up.",
#:   "Not over, not along, but both: a hiker angled through our lane.",
#:   "Let her set off for a door further down and take the diagonal.",
#:   "The distance to the old man grew and grew while he crossed, since his way over the street also led him up it, a walk on the bias.",
#:   "Pedestrian's heading was thirty-five degrees off the lane axis, constant from the north kerb to the south kerb, with the cyclist's lamp following.",
#:   "You'd have thought somebody had tilted the road, the way the girl on the bike slanted over it, off our side here and onto theirs far down there.",
#:   "Because the chip shop isn't opposite but up a bit, the lads go over the road on a slope, and we sat in their wake.",
#:   "Six parking bays further on than where he'd stepped off, that's where he stepped up, having walked one straight oblique line.",
#:   "Señor, she does not make the cross, she makes the slash, from this corner until that shop, with the back half turned to my auto.",
#:   "The crossing took him from the letter B of the painted BUS to the S, if you follow me, and over two lanes meanwhile. He walked at one pace and in one direction, only the direction wasn't the sensible one. I had slowed to let him be gone, and he was still there when I came up, in front and to the left.",
#:   "There's a wet trail on the tarmac, he'd been in the sea. It begins at the steps by the lifeguard's hut, which is on the right, and runs dead straight to the ice-cream van, which is on the left, and forty yards on. So it lies over the road like a sash. I'd the time to look, I was waiting for the feet at its end.",
#:   "Vehicle 1's operator believed she had ample time, expecting the woman to take the short way. The woman's car, however, stood on the opposite side some eighty feet farther up, and she walked to it by the direct route. She was therefore in Vehicle 1's lane, moving both away and leftward, for twice the time.",
#:   "How do you cut a sandwich? In triangles, says my learner. And that's how the gentleman with the easel is cutting this road. He doesn't go straight over and he doesn't go along the side, he's making for the corner over there with his shoulder to us, so he'll be in our lane till the next lamp post.",
#:   "We measured the exposure. Crossing at ninety degrees he'd have occupied the ego lane for 2.4 s. His path being laid at forty degrees, pointing down the street in our own travel direction, he occupied it for 3.8 s at the same unhurried walk. The ego, having allowed for 2.4, came within a metre of his heel.",
#:   "It was a habit from the fields, I suppose. Where they come from you go from the barn to the well, wherever these may be. So she left the tram stop on our right and simply went to the church, which is over the way and a good bit on, with her face to its clock and her back to the car.",
#:   "Control, the walker's on camera four now, he's left the north side. No, he isn't coming over to the car park, he's heading for the underpass, so he's going over at a slant, westward. Car behind him has slowed. Still in the road. Still in it. And he's on the south side now by the bollards.",
#:   "The tram rails are set in the road at a slant just there, where they change from one side to the other, and the child had made up her mind to walk on one. So she left the pavement with it, passed through our lane with it, one foot before the other at an even pace, and reached the other side with it, far up.",
#:   "My bike bell has broken so I couldn't warn the car. I wanted the cycle path that starts on the other side after the bridge. You can cross and then ride along, or ride along and then cross. I did the two at the same time, like always, and the car rolled after me with its nose at my back wheel.",
#:   "A short film in three stills. In the first, a hat is at the right of the windscreen and large. In the second it's in the centre and smaller. In the third it is at the left and quite small, and it's going in at a gate. Join the hats with a ruler, and you've the old gentleman's road to the allotments.",
#:   "Of all the ways to the other pavement he'd chosen the one that the crow would, if the crow lived behind the station and worked at the brewery. Thus, when they turned their heads, expecting him to have gone over, he was still before them, only farther on, walking steadily away across their lane like a man crossing a deck.",
#: ]
#: adversaries = ["pedestrian", "bicycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "diagonal"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.3
#: high = 4.5
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 18.0
#: high = 52.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_ADV_ANGLE"
#: low = 0.55
#: high = 0.9
#: unit = "rad"
#: meaning = "how far its way turns from straight across"

param OPT_ADV_SPEED = Range(1.3, 4.5)
param OPT_ADV_DISTANCE = Range(18, 52)
param OPT_ADV_ANGLE = Range(0.55, 0.9)

behavior AdvBehavior():
    # Earlier where it has farther to go, and briskly where the ego would be gone otherwise.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(5) until abs(offsetFrom(egoRoute, self)) < max(2.5, globalParameters.OPT_ADV_SPEED * headway(egoRoute, ego, self) / 12)
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE if offsetFrom(egoRoute, self) > 0 else -globalParameters.OPT_ADV_ANGLE)
