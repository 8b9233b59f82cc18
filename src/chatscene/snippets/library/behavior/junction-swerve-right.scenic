#: description = "The car enters the intersection and suddenly swerves to the right."
#: rephrasings = [
#:   "A vehicle coming in jerks over to its right-hand side.",
#:   "The adversary leaves its line through the junction with an abrupt lurch to the right.",
#:   "The other driver pulls sharply right toward the ego's lane.",
#:   "Midway over the crossroads the car veers off rightward.",
#:   "The incoming car dodges to the right without warning.",
#:   "he yanks it to the right halfway across for no reason",
#:   "Vehicle 2 veered abruptly to its right within the intersection.",
#:   "sudden right swerve inside crossing",
#:   "He was going straight on, then in the middle of the crossroads he yanked the wheel and lurched off to the right.",
#:   "Upon entering the intersection, Unit 2 veered abruptly to the right for no apparent reason.",
#:   "Car in jct, sudden jink R.",
#:   "Once inside the junction the target makes a rapid lateral deviation to its right.",
#:   "The car comes in the crossing and suddenly jumps to right side.",
#:   "Unexpected right-hand jerk mid-intersection, no indicator, no planned turn.",
#:   "He'd barely rolled into the crossing when something made him wrench the thing rightwards.",
#:   "He's entering the junction, and whoa, he's veered over to his right without any warning!",
#:   "he was in the middle of the junction and just SWERVED right out of nowhere",
#:   "The coach suddenly wrenched to the right inside the crossroads, throwing passengers from their seats.",
#:   "Within the junction, and with no warning, the lorry departed from its line toward the right?",
#:   "Inside the junction only, he suddenly pulled to right side, no signal nothing.",
#:   "Half over the crossing he gets a wasp in his ear and chucks it to the right.",
#:   "Abrupt rightward deviation of vehicle within intersection.",
#:   "SUDDEN SWERVE TO THE RIGHT MID INTERSECTION",
#:   "The bus flinched right inside the junction.",
#:   "Car's barely in the crossing and it darts off rightward.",
#:   "Coach rolls in, then an almighty twitch to its right.",
#:   "Make the lorry veer right, unprompted, once inside the junction.",
#:   "In the middle he flicks the bars to the right, no warning.",
#:   "V2 entered intersection, abrupt lateral departure toward its right side.",
#:   "Nothing odd about the pickup's approach, but as soon as it was in the crossroads it shied like a horse, away to its right-hand side.",
#:   "After entry into the intersection, the target is displaced laterally to the right by a rapid steering input, with no reduction of speed.",
#:   "Watch the other fellow over there when he's in the box: there, did you see, he yanked it to the right as though dodging something.",
#:   "Inside the crossing was a pothole, I believe, since the bus which had just come in was all at once thrown off its line to the right.",
#:   "The cab enter the crossroad normal normal, then he give one sudden cut on the steering to right hand side, I also got shock.",
#:   "How could I foresee that a motorcycle crossing the junction in a perfectly straight line would abruptly jink to its own right while it was in there?",
#:   "It wasn't a turn, I want to make that clear, he didn't take the road on the right. He drove the van into the junction, straight as you like, and then swung it over to the right in one jerk, as if his sat nav had bitten him.",
#:   "Planner dev here. Scenario: the SUV comes up to the intersection on its route, goes in, and shortly before our paths would meet it breaks off to its right with a sharp lateral move. Prediction still had it going straight, so our cost map was wrong.",
#:   "The officer asked me what I saw first. It was the load shifting: the tipper came into the crossroads and its body leaned hard over, because the man at the wheel had pulled it suddenly to the right. It never straightened up in the time I watched.",
#:   "Mr Pendle's saloon trundled into the crossing with its customary dignity, and for half of the way nothing happened. Then a paper bag blew up before the windscreen, he uttered a cry, and the whole machine bounded off toward the right like a startled hare.",
#:   "Dispatcher to all cars, we have several calls about the bus at Fourth and Main. It proceeded into the intersection and then, without any signal, went sharply over to its right-hand side. Callers do not know if the operator had taken ill or was avoiding something.",
#:   "Pickup rolls into the junction, then its nose snaps off rightwards.",
#:   "Simulate a motorbike that jinks to its right inside the crossing.",
#:   "SAT NAV SNEEZE?? bus lurches right mid-crossroads",
#:   "The lorry had come as far as the middle of the crossing on a dead straight course when a tug at the wheel threw it off to its right.",
#:   "Upon reaching a set distance from the meeting point, the target, already in the intersection, departs from its path towards its right-hand side with a steep lateral rate.",
#:   "What did the SUV do in there? It went straight in like everybody, and without any reason it leapt aside, to the right as seen by its driver.",
#:   "He is in the crossing, he is still straight, and then with one blow the motorcycle is tearing away to the right side, why, nobody knows.",
#:   "Careful of the coach, it's in the junction with us now... there it goes, it's kicked out to its right, no lamp, no warning, nothing.",
#:   "You were within the crossroads, holding straight, when you flung your van to the right; and you can give this court no cause for it?",
#:   "My mother noticed it before I did. She said, \"That man's dropped his sandwich,\" and sure enough the head of the driver went down behind the dashboard. His hatchback was in the junction by then, and it shot off its line toward the right as if the road had been whipped from under it.",
#:   "V2 entered the intersection from the west on a straight course, with no turn signal displayed. At a point some seven metres short of V1's path its heading altered to the right, within half a second, by about twenty degrees. Its speed remained the same. The driver stated that he \"must have pulled on the wheel\".",
#:   "Add a swerver to the junction family, please. It drives in as though to go straight over. Inside, near to where it would cross us, the steering gets one quick hard input to starboard, and off its path it goes, still at the same speed. Not a turn into a street, a jerk.",
#:   "I've carried pianos for thirty years and I know what a load does. That pickup went into the crossing with a fridge standing up in the back. The fridge toppled to the left, and that tells you what the pickup did: it had been yanked to the right, all of a sudden, with no call for it.",
#:   "There's a flock of pigeons that lives on that junction. I was waiting to see whether the minibus would scatter them, but it was the pigeons who scattered the minibus. It had gone in as meek as you like, and up they flew, and it bolted over to the right-hand side with all its passengers shrieking.",
#:   "The dispatcher wants it short so here it is. White van, no signage. Came into the intersection of Pine and Ninth going straight. Broke to the right out of the blue, hard enough that the hubcap came off. Don't know if he's drunk or dodged a dog.",
#:   "On a bicycle one looks at front wheels, they tell the truth sooner than the indicators. Those of the tipper pointed straight on as it entered the crossroads and for a couple of metres more. I then saw them flick round to the right, both, like two heads turning, and the body followed with a groan.",
#:   "We were talking about her exam results, I remember, and the cab over there was doing nothing out of the ordinary, just coming into the junction like I was. What made me shut up was its flank. You don't expect to be shown the left flank of something that ought to go straight past: he'd swerved off rightward.",
#:   "The bike came into the square of the crossing upright as a candle. Old Wenzel, at the wheel of the post car, had long ago decided that it would remain so. When the rider dipped his shoulder and was hurled, bike and all, away to his right, Wenzel did nothing at all, except say, \"Well, now.\"",
#:   "I could not anticipate. The bus in the crossing go straight, I calculate it go straight, I am engineer. But inside the crossing the driver suddenly pull to his right hand, very sharp, one second, maybe the man behind him shout. So my car must also react and the coffee is on my trouser.",
#:   "Comment pinned by the uploader: no, he isn't turning right, there's no road there, look at the map. He's entered the intersection normally at 0:12. At 0:13 he wrenches it over to the right for reasons best known to himself. I've slowed it down so you can see his passenger hit the window.",
#:   "Inside the crossing the bus flinches hard over to its right.",
#:   "SUV, mid-junction, one violent yank rightward. No reason seen.",
#:   "Straight in, then a kink: to its own right, suddenly.",
#:   "Over the first half of the crossroads the van's path was a ruled line; at the place where it'd soon meet ours, it jumped off that line to its right.",
#:   "When he'd got well inside the intersection the rider threw his weight to the right, and all at once his wheels were a lane's width from where they'd been heading.",
#:   "The steering angle of the crossing target shall step to the right once it is within the junction; its speed is not to be altered.",
#:   "Careful at this one, he's coming in normally, he's in, and, blimey, he's chucked it over to his right, did you see anything in the road?",
#:   "What the fare in the back saw was the lorry's load leaning to the left, because the lorry under it had darted to the right, halfway over the crossing.",
#:   "I need a car that goes into the crossroads as good as gold and, just short of where our ways would cut, jinks to the right-hand side with no warning.",
#:   "The dashboard camera has no sound, so watch the coach's roof. It comes into the intersection level as a table. Then it tips, outward to its left, as roofs do when what is underneath has been dragged to the right all in one go. Nobody was in the way there. It just did that, still at its old speed.",
#:   "Most folk who enter a junction do one of two things, I tell my pupils, they carry straight on or they take a proper bend. The motorcycle did a third. He was in, he was upright, he was past the middle nearly, and then the front wheel was flicked rightward, and he was off on another line beside the first.",
#:   "Had V2 held its heading, the point of impact would lie at the crown of the intersection. It lies four feet from there, on the side toward V2's right. Steering data agree: zero on entry, zero for 1.1 seconds inside, then sixty degrees of right wheel within a quarter of a second. Throttle remained where it had been.",
#:   "I was on a ladder with a brush in my hand, doing the sign above the pub, and I could look down his sunroof. The lad had one hand on the wheel until he was in the crossing. Something made him haul at it, that hand coming round and down on the right. The car hopped over sideways and the coffee on its dash went left.",
#:   "My wife's account and mine differ only as to the word. She says \"leapt\", I say \"lurched\". Both of us had the cab coming into the crossing with no fuss, both of us reckoned it would go through as it came, and each of us felt our own car brake when all that yellow was shoved over to its right-hand side at one stroke.",
#:   "The bug is that our tracker extrapolates the target's entry heading through the whole intersection. The SUV sticks to it for about six metres. Then there's a discontinuity: lateral velocity from nil to two and a half, toward its starboard side, same forward speed, and the box we had drawn for its future is empty.",
#:   "The bus that entered the crossroads and the bus that left it were on two different tracks, as though some child had picked the toy up in the middle and set it down again, farther to its right. Old Abbot had his foot on the brake already. He was not a man who trusted in buses.",
#:   "Why I was on the footpath with two wheels? Because I saw a van come in the crossing, he comes, he comes, all is straight, and I make my plan with this straight. And then comes a hook, to the right from him, so quick that his tyres shout, and my plan has suddenly a van in it.",
#:   "We're looking for the owner of a grey saloon that crossed the lights at Penn Street at about six. No signal was broken. It had proceeded into the intersection in a perfectly regular manner, and what brought the complaint was what it did there, which was to shy to its right like a horse at a paper bag.",
#:   "The gap through which I meant to pass lay on the right of the motorbike as the motorbike saw it, and it was a good wide gap as long as he stayed straight, which he did as far as the drain. From the drain on, the gap was him. One snatch at the bars and he filled it.",
#:   "Chap on the radio says junctions are where people die of surprise. I was surprised on Monday. A pickup trundles into one in front of my tanker, nothing to write home about. I'd even looked away. What I heard was tyres howling, and where I looked next it was over on its right, well off the path it came in on, and still going.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenario right-turn; own code"
#: [slots]
#: actions = ["swerve"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far it swerves"
#: [[parameters]]
#: name = "OPT_SWERVE_DISTANCE"
#: low = 0.0
#: high = 8.0
#: unit = "m"
#: meaning = "how far before the place where their ways meet it swerves"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_SPEED = Range(5, 10)
param OPT_SWERVE = Range(1, 3)
param OPT_SWERVE_DISTANCE = Range(0, 8)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < globalParameters.OPT_SWERVE_DISTANCE
    do SwerveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, -globalParameters.OPT_SWERVE)
