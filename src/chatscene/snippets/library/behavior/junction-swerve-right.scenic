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
