#: description = "The car enters the intersection, swerves to its left, and stops."
#: rephrasings = [
#:   "comes in, yanks it left and slams to a halt",
#:   "Vehicle 2 veered to its left inside the intersection and came to rest.",
#:   "swerves in crossing, then dead stop",
#:   "The target performs an abrupt steering input to the left in the junction and comes to a standstill.",
#:   "The truck goes suddenly to left side in the crossing and then it stands.",
#:   "A biker dodges aside and pulls up sharp.",
#:   "A van slews off its line and ends up standing askew.",
#:   "It lurches to one side and comes to grief there, motionless.",
#:   "car lurched over to his left halfway through the crossroads and then sat there",
#:   "After entering the intersection, V2 veered sharply left and halted.",
#:   "Van in jct: jerks to own L, then halts.",
#:   "Within the junction, the target makes an abrupt left steering manoeuvre and comes to standstill.",
#:   "The motorcycle comes in the crossing, he pulls to his left side and stays there.",
#:   "Inside the intersection: lateral jerk to the actor's left, then full stop off its own line.",
#:   "The bus was hardly in the crossing before it slewed to its left hand and came to rest askew.",
#:   "He's yanked the wheel over to his left in the middle of the junction and stopped there, what's he dodging?",
#:   "he got into the junction then yanked it to his left n stopped all wonky",
#:   "A van flung itself to its own left inside the crossroads and stood there at an angle",
#:   "Having entered the junction, you wrenched the wheel leftward and came to rest, for what purpose?",
#:   "Inside the junction he suddenly cut to his left hand side and stopped there itself",
#:   "Comes over the crossroads, flings it to his left like he's seen a ghost, and stops",
#:   "Abrupt leftward deviation of crossing traffic in the intersection with subsequent standstill",
#:   "Truck JERKS left mid-intersection and just stops",
#:   "The motorcycle darted to its left in the crossroads and stuck.",
#:   "Once inside the crossroads the cab lunges to its left and halts.",
#:   "Enters junction, hard left-hand jink by coach driver, standstill.",
#:   "He steer brusquely at his left in the intersection and rest there.",
#:   "Have the truck come in, veer to its own left, stop.",
#:   "Motorbike flicks left mid-crossing, and there it stays put.",
#:   "Barely into the intersection, the pickup jolted off course towards its left, as if dodging something, and pulled up where it was.",
#:   "We found the van at rest inside the junction, well left of its line, having been wrenched that way by its driver seconds before.",
#:   "The trajectory of the crossing SUV shows a sharp lateral shift to its left-hand side in the junction, followed by a deceleration to zero.",
#:   "Why would a bus, once past the line, hurl itself to its left and then not move another inch in the middle of the crossing?",
#:   "From my bike I saw the lorry roll into the crossroads, snap leftwards all of a sudden and come to a dead stand there.",
#:   "V2 proceeded into the junction; its operator swung the steering wheel rapidly to the left, after which V2 stopped short within the junction.",
#:   "There was a carrier bag blowing about, perhaps that was it. The little car came into the crossroads quite straight, then it ducked to its left, as a horse shies, and there it sat with its engine running and would not go on or back.",
#:   "The adversary keeps to its route up to the intersection. A few metres before the conflict point it is given a left steering impulse, so that it departs from its line to its own left, and it is then braked to a standstill within the junction.",
#:   "Our driver's head came round and he said a bad word. The minibus opposite had gone into the intersection and veered, to its left as its own driver sat, really sharply, and then it had parked itself in there with its hazard lights off and everybody staring.",
#:   "I'm telling you what I saw from my rig, up high. That motorcyclist rode into the crossing nice and upright, and then he threw the bike over to his left, must've been a pothole, and hauled it up to a stop before he'd got across.",
#:   "Q. When it entered the intersection, was it straight? A. It was. Q. And then? A. Then it darted to its left, her left, I mean the driver's. Q. Did she carry on? A. No, sir, she came to a stop in there.",
#:   "Enters the crossroads, lunges left, stands there.",
#:   "Into the box, wheel hard left, wheels locked, finished.",
#:   "A coach veers off to its left mid-junction and halts.",
#:   "The moped came over the line into the junction, darted to its rider's left as if stung, and was brought to rest there.",
#:   "V2 was within the intersection when it departed from its course to its left and, a short distance farther, came to final rest in the junction.",
#:   "that tesla drives into the intersection, yanks to its own left for no reason and just dies there in the middle lol",
#:   "For the crossing truck: straight into the intersection, then a sharp steer to its left, then brake to zero before it has cleared the junction.",
#:   "The lorry is entering in the crossing, he throws himself on his left hand and he remains parked, all the crossing is amazed.",
#:   "See how he's come into the junction and flung it over to his left, and that's him, stopped, so we stay put till he's sorted.",
#:   "I sell papers on that corner. A taxi came into the crossroads and I thought nothing of it, but his front wheels went over to his left like a shopping trolley's, and the whole car went with them. He stood on it after that; he ended up a lane away from where he'd been headed, in the junction still, scratching his head.",
#:   "What the drone saw was a tidy line into the intersection, a kink in it towards the left of whoever was at the wheel, and a few metres on from the kink a stationary van. The hazard lights went on after a minute. Traffic from our side needed a quarter of an hour to thread past.",
#:   "A pigeon walks where it likes, and that's how it began, I think. The bus had nosed in among the crossing lanes in the usual way. All at once its great flat front swung to the driver's left, the windows flashing, and there it was halted, at an odd angle, with everybody in it on their feet.",
#:   "The claimant was approaching the crossroads on a green aspect. The defendant's motorcycle entered it, deviated abruptly towards the defendant's left-hand side and ceased moving inside the junction. There it lay across the claimant's intended line, the rider upright in the saddle, and the claimant could stop only by mounting the refuge.",
#:   "I've my bus pass and all day to look out of windows. That young man brought his van into the crossing perfectly well, and then he wrenched it, to the left as he sat. Next I knew it wasn't going anywhere, it had pulled up where it was, and our driver had both hands in the air.",
#:   "Test 4c, lateral disturbance with terminal halt. On reaching the swerve point inside the junction, the target receives a steering pulse directed to its left and thereby leaves its reference path. Deceleration follows, so arranged that it is stationary before the far boundary of the conflict area is reached.",
#:   "Three black stripes tell the story. They start in the middle of the crossroads, where the pickup had got to; they curve away to what was its driver's left; and they finish under its tyres, because that's where I found it, still in the junction, not moving, with coffee all over the dash.",
#:   "For a heartbeat I thought he was coming round for me. The artic had entered the junction when the tractor unit jinked out to its left, trailer leaning after. Then the air went out of everything with a great sneeze and it had stopped there, in the crossing, forty feet of it, and neither of us could get by.",
#:   "At the crossing I have respect for scooters, because they do surprises. This one comes inside the crossing, good, then in one second he pulls the handle to his left side, maybe for a hole. He puts the two feet on the floor and there he is standing, not more moving, in the middle of everybody.",
#:   "Has anybody got the clip of the Dacia at the Five Ways? It's the one that drives into the junction completely normal, then zigs, no zag, just a zig to its own left. It's still sitting there stationary in the middle of it when the clip ends.",
#:   "And the lesson from that hatchback is look for where the wheels point. They pointed ahead as she drove into the crossroads; then they went hard over to her left, and the rest of the car had to follow. She scared herself, I expect, for she'd stopped dead by the time you'd reached the line, still inside the junction.",
#:   "Into the box, wheels cocked left, dead there.",
#:   "Lorry's halfway in, lurches leftwards, and that's where it stays.",
#:   "Over the line, a jink to his left, then nothing moves.",
#:   "The scooter's course, straight as far as the manhole in the junction, bends sharply towards its rider's left there and ends a few feet on, at a pair of boots.",
#:   "Target truck enters the intersection; steering step to its left at the swerve point; brake to zero within the conflict area; hold until end of run.",
#:   "was filming the lights for my channel when this van drives in, throws itself to its own left like it saw a snake and just stops there",
#:   "Inside the chowk he came straight, then handle he has pulled to left hand and there in the middle he is parked like his father's land.",
#:   "It was standing with its nose to its own left in the middle of the crossroads, and the hot tyres told me that it hadn't meant to.",
#:   "Nobody could say what the coach had dodged, only that it had lunged, to the driver's left, once in the crossing, and hadn't budged from there since.",
#:   "The ladder on its roof was what moved first. It swung, the van being well into the crossroads by then, till it pointed off to the left of the fellow at the wheel, and the van went where the ladder pointed. That was for perhaps two yards; then ladder and van quivered and were still, and we had no road to go on by.",
#:   "You'll find three sorts of debris inside the junction. The coffee is where the pickup was hauled off its line, as it flew out of the right-hand window when he went left. The dog basket is where he'd his brakes on hard. And the oil drip is where he stood for twenty minutes, since he never got out of the crossing.",
#:   "Here's the puzzle for the prediction team. For the first ten metres inside the intersection the crossing bus is on its lane centre to within a hand's breadth. In the next five it is a metre and a half off to its own left, and then its position no longer changes, and we're waiting at a box that will not clear.",
#:   "He'd a wasp in his helmet, he told me afterwards, and fair enough. What I saw from behind my windscreen was a motorbike coming into the crossroads as good as gold. Then the rider's left knee went down, the bike went that way with it, a skip, no more, and both his soles were on the tarmac and he was slapping himself about the ears.",
#:   "Instruction for waiting drivers. If the crossing vehicle, already within the junction, should depart suddenly from its course to its own left, don't try to slip by on the side that it has vacated. As this morning's taxi showed, it may pull up in that very place, askew, and you'd then be two vehicles in a junction going nowhere.",
#:   "On the tram we all leaned, though it wasn't us that swerved. It's catching, isn't it? That big yellow skip lorry came out into the crossing over there, head up, and then flung itself left, its left. Everybody on our side went \"ooh\". And then it gave a jerk and there it was, standing, with the skip still rocking on its chains.",
#:   "Witness 3, a window cleaner, had an overhead view. From the ladder he saw the roof of a red saloon pass under the traffic lights and into the centre. He saw it twist towards the driver's left-hand side. He had time to climb down and go over to it, since it was stationary there, in the centre, and remained so.",
#:   "I have learned the word today: to jink. The hatchback drives inside the crossing and he jinks. To the left, but his left, for me it's the other side! After the jink comes nothing. He stays in the crossing with hot brakes, and I, who had green, I have looked at him during two more greens.",
#:   "We expected a bang and there wasn't one. We'd seen the artic roll in over the line, and we'd seen the cab dart off to the side where the driver doesn't sit, I mean to his left, he was English. It's then that you expect the bang. But he'd got the anchors on; cab and trailer had stopped dead within the crossroads, bent like a dog's leg.",
#:   "Dad always says leave room for idiots, and there was room, as it turned out. A minibus was coming over the crossroads, all right so far, and then it went squiff. It went left for it, right for us, Dad said that's the same thing. It stuck there in the middle with its wheels all sideways and we went nowhere.",
#:   "The junction is small and has a fountain, and the fountain, one must suppose, had splashed him. For he'd ridden in with perfect composure, a large man upon a small moped; he gave a cry; the moped shot to his left-hand side, as a fish does, and there, among the traffic of four streets, he set down his feet and would go no farther.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["swerve", "stop"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 22.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 6.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.5
#: high = 3.0
#: unit = "m"
#: meaning = "how far it swerves to its left"
#: [[parameters]]
#: name = "OPT_SWERVE_DISTANCE"
#: low = 4.0
#: high = 9.0
#: unit = "m"
#: meaning = "how far before the place where their ways meet it swerves"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far beyond where their ways meet it comes to rest"

param OPT_ADV_DISTANCE = Range(0, 22)
param OPT_ADV_SPEED = Range(6, 10)
param OPT_SWERVE = Range(1.5, 3)
param OPT_SWERVE_DISTANCE = Range(4, 9)
param OPT_STOP_DISTANCE = Range(0, 3)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < globalParameters.OPT_SWERVE_DISTANCE + brakingDistance(self)
    do SwerveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory, 1, globalParameters.OPT_SWERVE)
