#: description = "The rider turns left and cuts the corner, riding over the wrong side of the road it leaves."
#: rephrasings = [
#:   "A scooter takes the left-hander on the inside, all the way over on the wrong side.",
#:   "The motorcyclist cut the corner while turning left across the path of Vehicle 1.",
#:   "moto cuts corner on left turn",
#:   "The powered two-wheeler takes a left turn with its trajectory shifted to the inside.",
#:   "The bike makes a left turn too narrow and comes on the false side.",
#:   "A courier shaves the inside of the bend as he swings left.",
#:   "The moped takes a shortcut over the centre line to go left.",
#:   "She leans in early and clips the apex of her left turn in front of us.",
#:   "The cyclist sliced the corner turning left and came right over the wrong side of the side road.",
#:   "The bicyclist made a short left turn, traversing the opposing lane of the street he was leaving.",
#:   "MC turns L, clips the corner, on wrong half of road.",
#:   "The two-wheeler turns left on a shortened trajectory leading over the opposing lane of its road of origin.",
#:   "The motorbike turns left too short and drives on the wrong side at the corner.",
#:   "Rider's left turn skips the apex, path runs through the oncoming half of the arm it exits.",
#:   "He could not be bothered to go round properly; he took the short way over the wrong half of the lane and was gone.",
#:   "See that moped, he's cutting the corner on his left, he's on the wrong side where you'd be waiting.",
#:   "biker turned left and totally shaved the corner on the wrong side",
#:   "The rider took the left-hand bend so tightly that he strayed into the lane meant for those coming the other way.",
#:   "In turning left he abridged the corner, and rode where opposing traffic had every right to be.",
#:   "That scooter took short cut in the left turn, coming full wrong side.",
#:   "Left turn by the short route, over the wrong half, as if corners cost money.",
#:   "Shortened left-turn line of two-wheeler with use of opposing lane",
#:   "BIKER SKIPS THE CORNER - wrong side!",
#:   "The motorcyclist shears off the corner leftward over the wrong lane.",
#:   "Moped nips left on the inside, wrong half of its street.",
#:   "Motorbike's left turn: tight inside line, opposing side used.",
#:   "Lazy left by the cyclist, straight over the wrong side.",
#:   "Who taught him to swing left via the oncoming half?",
#:   "Paperboy trims the corner going left, wrong side and everything.",
#:   "Let a motorcyclist turn left on the shortest possible line, so that he passes over the half of his road which belongs to those coming towards him.",
#:   "He should have gone out to the middle before turning left; the courier instead rode diagonally over the wrong part of the road he was quitting.",
#:   "V2, a bicycle, turned left early and crossed the opposing half of the street from which it was emerging rather than following the proper arc.",
#:   "The scooterist wants to go left, and he takes it so narrow that he is already before the corner on the side of the others.",
#:   "Any cyclist knows you don't take a left like that, hugging the inside and ending up where the oncoming stuff would be.",
#:   "Observe where the moped is when it goes left: well inside the normal line, over the half of the carriageway meant for vehicles entering that road.",
#:   "I was behind my kitchen window, which looks out on the corner, so I know. The boy on the bicycle didn't go round the end of the white line as he ought to have. He went left before it, over the other side of the road, to save himself four yards.",
#:   "With a nominal left turn the two-wheeler keeps to its own half until the apex. In this variant its path is displaced towards the inside of the turn, whereby it occupies the opposing half of the approach it is leaving and arrives earlier than predicted.",
#:   "He'd got a pizza going cold in his box, so of course the rider wasn't going to do the turn by the book. He dropped his shoulder to the left a good ten metres too soon and went over the wrong half of his own road at the mouth.",
#:   "Here's the learning point. Had you pulled right up, that motorbike would be on your bumper, since he's going left and he's doing it by the shortest way, across the portion of his road where you'd expect nobody to come out at all.",
#:   "The pedal cyclist explained that she always turned left there \"the short way\". By this she meant, as the court understood it, that she would leave her side of the lane prior to the bend and pass the corner upon the side reserved to opposing traffic.",
#:   "Moped's left goes over the wrong half of its own street.",
#:   "Cyclist swings left early, shaving the corner on the opposing side.",
#:   "Left-turning motorbike trims the apex via the oncoming half.",
#:   "Instead of riding up to the middle and bending round, the paper girl took her left diagonally, across the part of her road where others drive in.",
#:   "Give the scooter a left turn with the path pulled to the inside, so it leaves its road on the half which isn't its own.",
#:   "That lad on the moped fancied going left without the fuss of a proper corner, so he was on the wrong side before he'd even left his street.",
#:   "V2 (motorcycle) initiated its left turn short of the intersection and traveled left of the centerline of the street from which it was turning.",
#:   "The Radfahrer makes left, but he makes it too early and too narrow, he rolls there where the cars that come in must drive.",
#:   "Be advised the motorcyclist is making his left on the wrong side of the side street, cutting the angle completely, you could meet him nose on.",
#:   "It's the geometry that counts in this claim. Had the scooter kept to its own half till the mouth of the road, and then come round to the left, there'd have been space enough. It went left along the chord rather than the arc. At the mouth of that road it was on the half belonging to traffic that enters.",
#:   "Cyclists, I am one of you, so don't write in. But when you're going left out of a side road, please don't do what the gentleman with the panniers did on Friday. He leaned over well before the corner and slid out on the side where I, or a bus, or anybody turning in, would be.",
#:   "She had stopped the van, as one should, with the mouth of the lane in front of her, and it was a good thing that she had not rolled on another yard. For the boy on the moped, who was leaving it and wanted left, cared nothing for centre lines: round the inside he came, right along the kerb that wasn't his.",
#:   "A left turn can be wide, correct or short. The bicycle in this trial makes a short one. Its lateral offset is chosen such that it passes the corner at the kerb of the opposing half of the road it leaves. A system which only reckons with riders in their own half will be looking in the wrong place.",
#:   "The give-way triangle and the broken line at the end of Vine Street were repainted in spring, so nobody could miss them. The rider's wheels never touched his half of them. He was already bearing left ten yards earlier, over the lane for those coming into Vine Street, and popped out at the very corner, to go up the hill.",
#:   "When they come off the estate on those electric scooters they've all got one way of going left. They don't ride to the end. They see the corner, and draw a straight line to what's behind it, over the other lot's side. This one drew his line with me in the wagon, stood there with my toe on the brake.",
#:   "Log 77: motorbike exits the arm to the east, intent left. The predicted path (white) goes round the island. The actual one (orange) passes on the near side of the island, in the lane that leads into the arm, and so arrives in front of us about a second early. Corner-cutting should be in the prior for two-wheelers.",
#:   "\"Where would you have expected him to be?\" asked the coroner. \"On his own half, sir, going round.\" \"And where was he?\" \"On the other half. He'd chopped the corner off. He was turning left, and he'd put the motorcycle to the left of the line while he was still in Quarry Road, to get round quicker.\"",
#:   "Mr teacher say always: turn left must go big, turn right can go small. The food delivery man he turn left go small. From his road he ride already in the opposite lane, very near to the corner, and then left. If some car want to go into his road in that moment, bang, no chance.",
#:   "Bald tyre, late for his shift, wet leaves; he'd three good reasons to take it gently. The motorcyclist preferred to take it tight. His left-hander began on the correct half of Church Lane, and before Church Lane ended he had strayed to the half he'd no business on, knee out, so as to clip the corner by the war memorial.",
#:   "video title: \"biker takes the racing line\". its a residential street lol. hes coming out of it to go left, and instead of going round like a person he apexes it, knee nearly on the wrong kerb, whole bike on the side people drive IN on. cammer just sits there like ok valentino",
#:   "Moped lops the corner off its left, wrong side of its street.",
#:   "Bike's left: inside line, over oncoming's half.",
#:   "Left turn, scooter, apex on the wrong kerb.",
#:   "Anyone wanting to enter the side street would've met the cyclist there head-on, since she came out left by the half that's meant for entering.",
#:   "Let the motorcycle turn left the lazy way, crossing to the far half of its own street well ahead of the corner and trimming it.",
#:   "The white line at the end of Mill Street was to the right of the biker as he came out of there to go left, not to his left.",
#:   "A left-hander was made by V2, a bicycle, on the inside of the curve, with the whole of the opposing half of its approach under its wheels.",
#:   "Why go round the corner to the left, thinks the courier, if you can go through it, over the half where others come in?",
#:   "He comes from the little street for going left, but he takes the inside, there where I must enter, he shaves the corner with the elbow.",
#:   "Our van was waiting with its nose at the mouth of the lane, on what is indisputably the side for going in. We had every reason to think ourselves alone there. What came out, on that side, was a motorbike, heeled right over to the left and already aiming for the road behind us before it had left its own.",
#:   "There's a polished strip on the cobbles at Chapel Corner, hard against the left-hand wall as you come out. That's from bicycle tyres. It shouldn't be there, for the left-hand wall's where you go in. But they all come down on the wrong half to get their left over with quickly, and so did the one that met me.",
#:   "Had he driven to the middle of the junction and then gone left, we would have been at a comfortable distance. We computed it that way. His actual track lies up to three metres further inside: off his half of the street while he was still in the street, by the opposite kerb, and round, a diagonal, directly ahead of us.",
#:   "Do you see the scooter waiting to come out over there? L-plate, pizza box. I'll bet you a fiver he won't drive up to the line. There he goes, slantways, across the half of the road that isn't his, tight round the bollard and left. If you'd been turning in, you'd have had pizza all over your windscreen.",
#:   "My lad delivers papers, and I'm ashamed to say it was him. He was coming out of the close, left, on his bicycle. He'd the right-hand side to do it on. But he's fourteen and it's further, so he came out along the left-hand fence, the wrong side altogether, and whipped round the end of it under that lady's bumper.",
#:   "I pulled up in good time for the side road, sir, on account of a hedge which one can't see through. Out of the hedge, so it seemed, emerged a motorcycle bound leftwards. A motorcycle ought to have emerged a good four yards to the right of the hedge. It had been cutting across the half used by people arriving.",
#:   "Question in the theory exam: from which part of the side road will the left-turning cyclist emerge? Most tick the part on his right. The film then shows one who's drifted over to the part on his left and scrapes round the kerb there, against the arrows on the road. Expect it, says the explanation.",
#:   "The near miss was at the spot where he should least have been. My truck was stood at the junction. The lad on the Vespa was leaving the estate, going left. I'd watched the proper gap, the one on his own side, so the first I got of him was a knee, on the other side, coming round the inside of the bend.",
#:   "Arrows are painted there since March, one out, one in. The rider of the e-bike took the one marked \"in\" for his way out. He was turning left, I must admit that it's shorter so. You spare yourself the outer half of the curve. You also spare nothing to whoever's approaching, in this case our robotaxi and its sleepy passenger.",
#:   "Looks like a normal left on the map app, doesn't it, a nice round blue curve. Now put the real trace over it. It sags. The rider's left the right half of Birch Avenue thirty feet before the end, he's run through the half that's for the cars turning in, and touched the corner of the pavement on the way.",
#:   "All day we had rehearsed it with the bicycle keeping to its own half until the turn. \"Again,\" said the director, \"but lazily.\" So the girl set out, let herself drift over the middle of the lane she was in, hugged the wrong-hand curb, and came left around it in a short little bow; and the driver gasped for real.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["acrossMeeting", "advMeeting", "advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["turn-left", "follow"]
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -2.0
#: high = 24.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 7.5
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.0
#: high = 2.2
#: unit = "m"
#: meaning = "how far it cuts to the inside"

param OPT_ADV_DISTANCE = Range(-2, 24)
param OPT_ADV_SPEED = Range(4, 7.5)
param OPT_SWERVE = Range(1, 2.2)

advTurn = "left-turn"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, acrossMeeting) < globalParameters.OPT_ADV_DISTANCE + 7.5 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE)
