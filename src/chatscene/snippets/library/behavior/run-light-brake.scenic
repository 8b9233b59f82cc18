#: description = "The crossing vehicle runs the red light and brakes abruptly."
#: rephrasings = [
#:   "A car ignores the signal and then slams to a standstill in the junction.",
#:   "Having jumped the lights, the adversary hits the brakes before the ego.",
#:   "The other driver crosses on red and stops short.",
#:   "Against the red a vehicle rushes in and decelerates hard.",
#:   "Cross traffic overruns the stop line on red and brakes in the middle.",
#:   "he shoots the red and then slams the anchors on in front of us",
#:   "Vehicle 2 entered on red and braked heavily inside the intersection.",
#:   "The truck passed with red and in the middle it brakes very strong.",
#:   "This van shot the lights and then stood on the brakes in front of me.",
#:   "Cross traffic unit disregarded the red signal and suddenly braked within the intersection.",
#:   "Bus jumps red, then hard brake, in our path.",
#:   "The crossing vehicle disregards the red phase and decelerates abruptly in the conflict area.",
#:   "The car goes over red and then brakes suddenly.",
#:   "Red-light runner realises too late, slams brakes in the box, sudden decel rather than a stall.",
#:   "He had gone through on red before he saw her, and then he stamped on the pedal with both feet.",
#:   "That motorbike's come through his red and now he's panicked and hit the brakes.",
#:   "ran the red and then panicked and braked right in front of everyone",
#:   "A lorry went through a red signal and then pulled up sharply amid the crossing.",
#:   "You passed the signal at red and, too late to any purpose, braked violently.",
#:   "He jumped signal and then in the junction put sudden brake, no sense.",
#:   "Goes through on red, sees me, and chucks everything at the brakes, bit late now sunshine.",
#:   "Red-signal violation of crossing vehicle with subsequent harsh deceleration",
#:   "BLOWS THE RED, THEN PANIC BRAKES",
#:   "The crossing truck ignores the red and suddenly clenches to slow.",
#:   "Through a red from the side, then hard on the brakes.",
#:   "Pickup from the left: red ignored, then an almighty stamp of the brakes.",
#:   "Biker ignores his stop light, panics, grabs every bit of brake.",
#:   "Have a lorry cross on red and abruptly decelerate inside the junction.",
#:   "Coach jumped its red, next thing its brakes were screaming.",
#:   "The signal facing the taxi had long been red; it sailed in from our right nonetheless, and then its driver stamped the pedal flat.",
#:   "From the side street comes a bus, he doesn't look at his red lamp, he drives in, and there he makes suddenly full braking.",
#:   "After violation of its stop signal the transverse vehicle shall enter the intersection and be decelerated abruptly on reaching the conflict zone.",
#:   "\"He had no business being there, his light was against him,\" said a shopkeeper, \"and then I heard the tyres as he braked.\"",
#:   "Did this hatchback honestly blow through the red only to slam on the moment it saw us coming over?",
#:   "We've got a heavy goods gone past a red on the cross street, and now he's stood on everything in the middle.",
#:   "Our side had been green for some seconds when a saloon came in off the cross road against its signal. Right before us the bonnet dipped sharply, smoke came off the front wheels, and my daughter shouted from the back.",
#:   "Signal records confirm that V2 entered on a red indication four seconds old. Tire marks beginning beyond the crosswalk show that V2 was then braked heavily within the intersection, V1 having the green at that time.",
#:   "The light-runner in this variant isn't smooth. He comes from the cross road, disregards the red, is already over the line and well into the box when he has a fright and brakes violently, which spoils our time-of-arrival estimate.",
#:   "The young man on the motorcycle told me he thought it was still amber. It was not, it was red as a tomato. And having gone in, he lost heart and squeezed the lever till the back wheel came up.",
#:   "I stand at the crossing with my scooter and I see it all. The van of the bakery has the red fire, it passes in spite of that, and after, in the centre, it brakes with a big cry of tyres.",
#:   "Through on red, then all anchors, right in the crossing.",
#:   "Cross traffic beats nobody: red ignored, brakes slammed.",
#:   "Against his signal he came on, then stood on it.",
#:   "Green for us, red for the coach from the side; in it came and, over the line, its driver hit the brakes for all he was worth.",
#:   "He took the red like it's only a colour, this truck, and once inside he made a braking that you could hear in the next village.",
#:   "The side road's light had gone red well before the moped crossed the line, and well after it the moped all but went over its handlebars braking.",
#:   "Please let the van from the left disobey its red light and, when it's in the conflict area, brake abruptly at the limit of its tyres.",
#:   "How does somebody fail to see three red lamps, drive in among us, and only then stamp on the pedal as if the floor were on fire?",
#:   "Red phase, cross street: one minibus, non-compliant, sudden deceleration of some 8 m/s² initiated beyond the stop line, about four metres from our path.",
#:   "There's a mark on the junction that begins where no mark should. If he'd braked for his light it would begin at the stop line, or before. It starts nine metres past it, two thick black stripes, pointing at where our car was. The signal records, the officer said, had him on red for three seconds by then.",
#:   "My daughter has just passed her test, so she goes when it's green, and it was. From the right came a pickup for which it consequently wasn't. He didn't lift for the line. He did see her then, because the load came up over the cab, and that was the brakes, and that's the reason I've still got a daughter.",
#:   "On the number 12 we were all thrown forward like skittles, and I'll tell you when. Not at the light. Our driver had gone straight past the light, red as a cherry, I was sitting behind him. It was in the midst of the crossroads, when a little white shuttle showed up, that he trod on the thing.",
#:   "Two mistakes make this one hard for us. Mistake one, the motorcyclist from the side street doesn't care for his red and is over the line at forty. Mistake two comes in the box: he grabs the brake suddenly. Had he kept going we'd have had a clean gap behind him, and that's the gap we'd planned on.",
#:   "You've a green, so what do you look at? The others, that's right. And that saloon there hasn't slowed for his red, so he's coming through, hold back. Oof! Now he's noticed, and he's jammed on the brakes with his whole car on our crossing. See his nose go down? Never trust a colour.",
#:   "V2's signal had been red for 4.1 seconds at the time it crossed the stop bar. Event data show throttle application up to that point. Within the intersection, 26 feet past the bar, the data show brake pressure rising to maximum at once. The operator of V2 stated, \"I looked up and there was a car.\"",
#:   "It was the tyres that made her look round from her tea. A lorry was howling down on its own nose in the middle of the cross; its load had shifted with a boom. And above it, calmly, hung the lamp which it should have obeyed and which had been red, she would swear to it, since she poured the milk.",
#:   "In France I was cyclist at the green fire, and I've lived. The camionnette which had the red has continued as if I and the fire didn't exist, and it was on the place of the crossing, so to say on my foot, that it has braked all of a sudden, with smoke. I've said to it some words.",
#:   "\"Had you a red light?\" \"I believe so.\" \"And you entered.\" \"I did.\" \"Where, then, were you when you braked?\" \"In the junction, sir.\" \"Gently?\" \"No, sir, with everything, my passengers complained.\" \"You saw the plaintiff's car?\" \"That's why I did it, sir.\" The taxi driver asked for a glass of water.",
#:   "Clip of the week comes from a school crossing in Leeds. Ours is green. Enter, from the left, one ice-cream van that has clean forgotten about red. It's doing its jingle. And halfway through the jingle, halfway through the junction, the guy does the emergency stop of his life and a tub of cones hits the glass.",
#:   "Dear sirs, my premium shouldn't suffer. The other party passed a light that had been red for him since before I changed gear. If he'd then only gone on! But, perceiving me, he put on his brakes with extreme suddenness in the very centre of the crossing, whereupon my choice was his door or the lamppost.",
#:   "Ignored its red, then screeched in mid-crossing.",
#:   "Side-street coach: past red, then everything on the brakes.",
#:   "Light against him, in he came, and panicked.",
#:   "Only once the stop line, the zebra and half of the box lay behind it did the taxi, whose lamp was red, find its brakes, and then it found all of them.",
#:   "We had green and so the other hadn't, yet he drove in; what made my son shout was the way the lorry's cab bowed down in front of us.",
#:   "Let the cross-road motorbike flout its stop lamp at normal town speed and, as soon as it's on the ego's side of the box, brake for dear life.",
#:   "He had red, he saw it not or he wanted it not, he was already in the crossing, and suddenly he stamps so that the car is standing on the nose.",
#:   "The smell of burnt rubber hangs over the middle of the junction and not before the line, your worship, which is where a man with a red should have made it.",
#:   "Unit four advises that a minibus has gone through on red from the east side, no attempt to slow, then slammed everything on inside, passengers on the floor.",
#:   "You'd think the bad bit is running the red. For those of us with green the bad bit's what followed. The pickup from the side road was over its line and coming, so I'd timed it: he'd be past before I got there. He looked to his left. The whole thing went down on its knees, and my timing was waste paper.",
#:   "I count tyres for a living. There are four marks, they're all within the yellow box, the longest is eleven metres. The lamp that the van had to obey stands nineteen metres before the first of them and, as the controller will tell you, it had been showing red for a while. So he obeyed something. It just wasn't the lamp.",
#:   "When a bus brakes sharply you see the passengers wave, they all go forward with one arm up. I saw them do it from my scooter at the green. It puzzled me as to the place, for they ought to have waved back there, by their red light. They'd sailed by it. They were waving in the middle of the crossroads, straight across my way.",
#:   "Please log this as two separate cues for perception. One, the crosser's speed doesn't fall ahead of a signal that's red for him. He'll violate. Two, within the intersection his pitch angle jumps by three degrees and his wheels lock. The second undoes the prediction from the first, and the second comes with only fourteen metres left.",
#:   "What woke the baby? Well, not the lights. We were rolling up on green, all peaceful, when this saloon appeared out of the side road where it was as red as could be. It didn't wake her. What did was the yowl of it as it got in amongst us and the woman saw what she'd done and trod on it with all her weight.",
#:   "My granddaughter drove and I held the eggs. She says the man was colour-blind; I say he was late. He came across regardless of his red, on one of those big motorbikes, and he was a fair bit out into it before he clapped eyes on us. Down went the front, up went the back. I've never held eggs like it.",
#:   "A lorry obeys its driver with a delay, especially with twenty tonnes of sand. So I ask the gentleman, why he pressed so strong when he was already in the crossing, and not when the lamp told him? It was red for him since five seconds. The sand has come over the cabin, the wheels have screamed, and my wife also.",
#:   "V1 entered on green at 22 mph. V2, on the cross street, passed its stop bar against a red signal at 34 mph. No braking is recorded for V2 at that point. Braking begins 1.1 seconds later, at 100 percent, with V2's front already beneath the center of the signal span. The occupants of V1 reported hearing \"a scream, then saw it was tires\".",
#:   "Green is a promise that others make on your behalf. He thought so, at least, and drove on the promise. The tram driver's cousin, in a bread van, hadn't been consulted. He'd let his own red go by like a station where one doesn't get off; and it was here, among the people, before their very lamps, that he pulled the emergency cord.",
#:   "You've heard of a rolling stop? This was the opposite. A rolling go, and a stop that didn't roll. He comes up to a solid red on the side street, doesn't lift, he's in. Then he sees the robot shuttle with the kids on board. And I swear, all four wheels, smoke, everybody on the patio stood up. In the middle. Of the junction.",
#:   "cyclist pov: my light green. side road bus light RED like been red ages. bus comes anyway, whatever, i brake. then halfway over he sees me n SLAMS it, hear all the people inside go ooof. dude ur already in the junction what is braking gonna do",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenario red-light-running; own code"
#: [slots]
#: actions = ["run-light", "brake"]
#: position = "crossing"
#: control = "signal"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 6.0
#: high = 11.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.0
#: high = 4.5
#: unit = "m"
#: meaning = "how far beyond where their ways meet it comes to rest"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_SPEED = Range(6, 11)
param OPT_STOP_DISTANCE = Range(0, 4.5)

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory)
