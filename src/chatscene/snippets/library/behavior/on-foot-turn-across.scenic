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
#:   "Facing us along the gutter, then suddenly broadside, going over.",
#:   "The postman, coming our way, hung a sharp one across.",
#:   "Jogger towards us, right-angle turn, straight through our lane.",
#:   "His lantern came nearer along the verge, as steady as you like, and then instead of going by my window it swung off and over the road before me.",
#:   "Nothing in that nun's approach, eyes front on the hard edge, told our software that at nine metres she'd make a quarter turn and step over the lane.",
#:   "I want the boy on the tricycle to trundle to meet the ego on the paving edge and, out of the blue, veer square across to the other kerb.",
#:   "Madam, you'd been walking to meet the traffic, at the side, as one should; what in the world made you strike out over the carriageway at that instant?",
#:   "We were to pass her, the woman with the pram, with a metre to spare; she pivoted and, pram first, made that metre into the whole road.",
#:   "On the border of the street he comes with his bicycle to me, he isn't looking, and all at once he's cutting over my nose to the bakery.",
#:   "I know the exact moment because of his shirt. It had a number on the chest, 88, and nothing on the sides. For as long as he jogged along the roadside toward me I could read 88. Then I couldn't. I could see an arm and a white stripe, going over from one gutter to the other, and I was on the brakes.",
#:   "There must be a word for people who lull you. This grandad was pacing up the edge, face on, stick, paper, cap, so regular that I'd already filed him under \"passed\". Some ten yards short of my bonnet he just stopped being parallel. He squared off, and on he went at the same plod, over to the bench, with my bumper by his knee.",
#:   "The lateral distance in our log is a flat line for six seconds, two metres ten, with the girl on the bike drawing nearer from ahead. At the trigger it drops like a stone: 2.1, 1.4, 0.5, minus 0.4, minus 1.3. She's gone from one side of our lane to the other without a glance and without getting any quicker.",
#:   "He was feeding the ducks, I found out, and the ducks had moved. All I had was an old man coming up the grass edge towards my lorry with a paper bag, no bother to anyone. Next he's between my headlamps and the brook's on his other hand, because he'd turned on the spot after them and gone straight across.",
#:   "Because the dog is on my left and the kiosk on my right, the lady told the court, I'm obliged to go over somewhere. She had chosen not to mention it to the driver, whose car she'd been walking to meet along the edge line for a hundred metres. She merely wheeled, dog and all, and was in the middle of his lane.",
#:   "What are you going to do about the cyclist? \"Nothing, he's coming the other way and he's right in at the side.\" That's what I thought in 1987, about a lad with a fishing rod. He'd been just as right in at the side. He turned that rod broadside to me at the last moment and pedalled over; I've still got the float.",
#:   "It's not forbidden, as the policeman explained, to change your direction. But who goes along the street in front of my eyes, on the border, toward me, for one whole minute, why must he change it when I'm ten metres from him? He went over by a right angle, like a soldier who hears his name. I've bent the lamp post.",
#:   "From the upstairs window it looks like chess. The white car is coming down the file. The girl with the scooter, on foot, pushing it, is coming up the edge of the board to meet it; she'll go by. And she doesn't, she takes a step to the side, and another, and another, and the white car must stop as there's a queen on its file.",
#:   "V1 was proceeding west in the right lane. The pedestrian, facing V1, was walking east on the paved shoulder carrying a gas can. When V1 was roughly 45 feet away the pedestrian, whose vehicle was across the road, made a ninety-degree turn and walked through V1's lane. He neither ran nor paused, and he stated he \"forgot\".",
#:   "She came along the kerb towards them under the limes, reading, and he thought how the book would look from beside, when they had drawn level. He was to know sooner. Without lifting her eyes from it she turned, as one turns a page, and crossed before the wheels of the cab, and he saw the title upside down in the lamps.",
#:   "so theres a kid coming at us on a bike along the kerb doing that no hands thing. robotaxi gives him loads of room. then he spots his mate on the other side n just leans, still no hands, 90 degrees, rides right over our lane. taxi does a full stop. kid still no hands. legend",
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
