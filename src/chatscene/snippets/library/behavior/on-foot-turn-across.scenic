#: description = "The oncoming pedestrian walks along the edge of the road and suddenly turns off across the ego's lane."
#: rephrasings = [
#:   "She's coming our way on the side and without a look turns straight over in front of us.",
#:   "A pedestrian walking against traffic turned abruptly and crossed the path of Vehicle 1.",
#:   "oncoming ped, sudden right-angle turn across lane",
#:   "The target approaches beside the lane and then crosses it perpendicularly.",
#:   "The cyclist comes from front on the border and then goes directly over our lane.",
#:   "Somebody who meets us decides all at once to change pavements.",
#:   "A kid on a bike heading toward us hangs a left over the road.",
#:   "The postman coming up the street makes straight for a door on the other side.",
#:   "He was plodding up the verge towards me and then turned on his heel and cut straight over.",
#:   "Pedestrian was walking along the shoulder facing traffic when he abruptly turned and crossed in front of Unit 1.",
#:   "Cyclist along edge, facing us, sudden turn-off thru our lane.",
#:   "The target moves along the road edge opposite to the test vehicle's heading and without warning changes course across the lane.",
#:   "A man walks at the side in my direction, suddenly he turns and goes over before me.",
#:   "Edge walker comes at us, then heading snaps ~90 deg into our lane and keeps going, no pause.",
#:   "She was coming along the edge as good as gold, and then she wheeled about and went over right under his nose.",
#:   "Walker facing you on the shoulder, fine, oh no, he's turned and he's going right over in front of you.",
#:   "she was walking on the side coming towards me n then randomly turned and went across",
#:   "A pedestrian who had been keeping to the roadside toward the car abruptly veered over the lane.",
#:   "He came along the margin facing the defendant and then, with no sign given, struck out across.",
#:   "He is coming along the road side opposite to me, then without seeing he took turn and crossed.",
#:   "Minding his own business along the edge, coming my way, and then wheels off right across my bonnet.",
#:   "Sudden course change of facing roadside walker or cyclist across own lane",
#:   "WALKING ALONG THE SIDE... AND SUDDENLY ACROSS!",
#:   "The jogger facing us along the roadside swings off across the lane.",
#:   "Kid cycling our way on the shoulder suddenly turns over the lane.",
#:   "Old man approaches along the verge, then abruptly heads across us.",
#:   "Jogger facing traffic at the roadside, unannounced ninety-degree turn over our path.",
#:   "Let a dog walker come toward the AV kerbside, then peel off across.",
#:   "Newspaper boy, oncoming on the edge, breaks sideways through our lane.",
#:   "The woman with the pram had been strolling in my direction by the gutter when out of the blue she set off to the other side.",
#:   "In the approach phase the cyclist moves opposite to the subject vehicle at the lane border, then rotates by ninety degrees and traverses the lane.",
#:   "You had him in view, walking to meet you on the roadside; did anything tell you he'd turn and march over your lane?",
#:   "At the border of the street one uncle was walking towards our side only, and all of a sudden he turned and was cutting across.",
#:   "There's this girl on a folding bike, she's coming up the edge to us, no signal no nothing, and bam, straight over the front.",
#:   "She ended up on the far pavement, having till then come along the near margin toward us and then swivelled over our lane.",
#:   "I passed the time of day with nobody, I was watching the road. A rambler was coming along the grass strip toward me, whistling, and without so much as a look round he altered course and strode over in front of my bonnet.",
#:   "The pedestrian was walking northbound on the paved shoulder, facing southbound V1. As V1 drew near, she made a sharp turn to her left and proceeded across the travel lane, later stating that she'd seen a friend on the opposite side.",
#:   "Here's one the predictor should hate. A person walks along the roadside toward the robotaxi, heading steady for five seconds, textbook parallel motion. Then the heading flips to perpendicular and she goes over the lane at the same walking speed.",
#:   "The postwoman on her yellow bicycle comes to me, very correct on the border, I am not afraid. But a letter is for the house on the other side, and she turns there directly before my wheels and goes over.",
#:   "With trucks you sit high and see them early. There was a hitch-hiker trudging up the hard edge at me, thumb down, minding himself; next thing, with no warning, he'd turned through a right angle and was tramping over my lane.",
#:   "Walking to meet us on the edge, she abruptly squared off across.",
#:   "Cyclist coming down the gutter at us, then hard over our lane.",
#:   "He'd been facing us on the verge; suddenly he's broadside before us.",
#:   "The walker who was due to pass my nearside wing turned his back on the hedge and marched over the lane instead.",
#:   "Make the boy come toward the robotaxi on the hard shoulder and, all of a sudden, wheel through ninety degrees and walk over our lane.",
#:   "As she neared us on the kerb stones I could see her face; then I saw her profile, and it was going past my bonnet.",
#:   "Along the border of the road he's coming against me on bicycle, and at once he is cutting over, without the smallest look.",
#:   "Pedestrian trajectory antiparallel to the ego, on the road edge; at trigger gap, heading rotated by a right angle, pace unchanged, lane traversed.",
#:   "Would you have guessed that the postwoman who came along the grass toward your car would all at once strike out for the letter box opposite?",
#:   "You'd think that someone who faces the traffic, as the Highway Code advises, has seen it. This gentleman with his haversack had come along the white line in my direction for a hundred paces. He looked me in the eye. And he then turned square to the road and walked over, as calm as a cow, before my wheels.",
#:   "The hoop was rolling first, on the kerb side, and the girl was walking after it, so they were both coming my way. It hit a stone and trundled over my lane. Without a thought for anything else she swung round and walked after it, straight over, and I stood the milk float on its nose.",
#:   "How it looked from my window seat: there was a nun with an umbrella, in the gutter, getting bigger, as one does when one approaches. I thought we'd pass her by. Then the umbrella swivelled, and what I had was the whole length of her, side-on, striding over in front of our bus to the convent door.",
#:   "Not much to it, officer. The paper boy pedals up the edge towards me, same as every day, throwing papers. I give him his bit of room. Only today he's forgotten number seven, which is over on my side, and with no signal he's hooked the bike across and gone over my lane, and I've gone into the skip.",
#:   "The interesting part is how ordinary the approach is. A person, on foot, by the road edge, heading opposite to ours; lateral offset a constant two metres; nothing that a risk model would flag. And from one step to the next the velocity vector is at right angles to our lane, and our lane is where she is.",
#:   "He was drunk or deaf or in love, that man, but he was not in a hurry. I had him in view on the shoulder, as he came toward me under the plane trees. Some five lengths from my bumper he turned on his heel as a soldier does, and went over to the vineyard side at the same stroll.",
#:   "V1 was eastbound. The pedestrian was proceeding westbound on the paved shoulder, facing V1. The pedestrian's head was observed to turn and, with no interruption of stride, his course changed by about 90 degrees, taking him over V1's lane from edge to edge. He was carrying a ladder, which struck V1's mirror.",
#:   "The dog did it, to be fair. They were both of them coming along the edge of the lane in our direction, nicely to heel. A squirrel went up a tree on the far side of me. So dog goes, lead goes, and the woman at the end of it, she's wrenched round and towed over the road right in front of my lorry.",
#:   "Imagine you are a robot and you like straight lines. An old man draws you one: he walks along the roadside, toward you, always in the same distance from the gutter. You're happy. Suddenly he breaks his line like a stick, and the second half of it lies across your lane, and he is walking on it.",
#:   "So much for eye contact. The rider of the cargo bike had been pottering up the side of the road, facing the car, close enough in that they'd have slid past each other with a metre between. She waved. And still waving she put her front wheel round and rode over, kerb to kerb, across the car's way.",
#:   "me and nan were in the taxi. there was a jogger comin towards us at the side, just jogging, not fast. nan says hes got nice legs. then hes sort of turned a corner where there isnt a corner and jogged straight over the road, the taxi went mad braking",
#: ]
#: adversaries = ["pedestrian", "bicycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior", "advFacing"]
#: origin = "own code"
#: [slots]
#: blocker = false
#: actions = ["oncoming", "swerve", "cross"]
#: position = "oncoming"
#: place = "road"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.4
#: high = 4.2
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 4.0
#: high = 20.0
#: unit = "m"
#: meaning = "distance to the ego at which it turns across"

param OPT_ADV_SPEED = Range(2.4, 4.2)
param OPT_ADV_DISTANCE = Range(4, 20)

# It faces against the ego's direction.
advFacing = 3.14159

behavior AdvBehavior():
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for 1 seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 1.57)
