#: description = "The vehicle runs the red light and makes an abrupt left turn."
#: rephrasings = [
#:   "A car ignores the signal and swings sharply to the left inside the junction.",
#:   "Jumping the lights, the adversary turns left in front of the ego.",
#:   "The other driver crosses on red and suddenly cuts left.",
#:   "Against the red a vehicle enters and hauls the wheel over to the left.",
#:   "The motorcyclist disregards the lights and sweeps round leftward.",
#:   "he jumps the red and yanks it left",
#:   "Vehicle 2 entered against the signal and turned sharply to the left.",
#:   "runs red, late hard left",
#:   "He went through the red and then wrenched it left all of a sudden.",
#:   "Vehicle 2 disregarded the red signal and made a sharp left turn.",
#:   "Red jumped, then snap L-turn.",
#:   "The target passes the red signal and executes an abrupt left turn in the junction, without halting.",
#:   "The bus ignores red and turns very sudden to left.",
#:   "Red-light runner who hooks a hard left instead of going straight; completes the turn.",
#:   "The light was red, but through he came, and without a blink he threw it round to the left.",
#:   "He's jumped the lights and he's slinging it left, watch him come round!",
#:   "ran the red AND whipped a left, just casually",
#:   "The van ignored the stop signal and wheeled suddenly to the left, keeping going.",
#:   "It was against a red signal that you threw your vehicle to the left, was it not?",
#:   "Red signal, still he turned left suddenly, one shot, gone.",
#:   "Doesn't fancy waiting on the red, so it's hard over to the left and away.",
#:   "Abrupt left turn by vehicle in violation of red signal.",
#:   "BLOWS RED LIGHT WITH A CRAZY LEFT TURN",
#:   "The bus defied red and whirled left.",
#:   "Lights against him, biker flings it left through the junction.",
#:   "Coach: red disregarded, sudden left, drives off.",
#:   "He was meant to wait, red and all, but shot in and veered left.",
#:   "Hatchback barges past the red and jerks away to the left",
#:   "Signal violation by crossing truck; sharp leftward turn, no halt.",
#:   "I want a van that comes over the line although it has red and, inside the intersection, is pulled hard to the left without slowing to a stop.",
#:   "According to the traffic camera the bus passed a signal that had been red for four seconds, and then hooked away abruptly leftwards.",
#:   "V2 failed to obey the red, entered, and changed direction to the left so suddenly that its load shifted against the side of the trailer.",
#:   "The motorcycle does not respect the red light, he passes it, and of a sudden he lies down to the left and goes.",
#:   "Not only has the pickup treated the stop light as decoration, it's also thrown itself left in the middle of the junction like a rally car.",
#:   "Left, and violently so, went the lorry, which by rights ought to have been standing at its red light all that time.",
#:   "We had the green and the robotaxi was rolling. From the side comes a minicab that's got the red, doesn't so much as dab the pedal, and once he's in the middle he lobs it to the left with the tyres squealing, and off down the road he goes.",
#:   "Infringement one: the driver did not comply with the red signal. Infringement two: having entered the junction, he made a turn to the left of such abruptness that no other user could have anticipated it. He completed the turn and left the scene.",
#:   "I drive a tram, I see everything. This lady in the big SUV looked at the red light, I mean she looked straight at it, and drove in anyway. Then she must've realised it was her street, as she whirled the wheel to the left all at once and went round.",
#:   "Actor ignores its signal phase (red) and enters the box at constant speed as if going straight on. Late in the box, at the given distance from our path, its heading steps to the left by about ninety degrees, and it departs along that new direction.",
#:   "The scooter's lights were red. I know they were because mine had gone to green. Through it came all the same, wobbly little thing with a huge parcel on the back, and then it heeled over and darted left, quick as a fish, and kept going.",
#:   "Minicab treats red as green and flicks itself left mid-junction.",
#:   "Red for him; in he drives, and snaps leftwards without warning.",
#:   "HGV violates signal, then wrenches itself left and away.",
#:   "It had the red, that lorry, and nobody would have guessed it was even turning until it lurched to the left in the very middle.",
#:   "Let the motorcycle disregard its red, come into the box as though for straight on, and then bank over to the left all at once.",
#:   "There's a coach coming against its red, no, it's not going over, it's dived left, it's through, carry on when he's gone.",
#:   "The light for the pickup is on red, he passes like nothing, and in the middle of the cruce he gives a wheel-stroke to the left.",
#:   "Unit 2 crossed its stop bar three seconds into the red, and its path within the intersection shows a sharp deflection to the left at undiminished speed.",
#:   "You'll fail if you do as that SUV does: ignores a light as red as a tomato, then hauls itself leftward as though he'd forgotten something.",
#:   "It's a crossing I use every day on my bike so I know the phases by heart. Ours had just gone green, so theirs had been red for a good while. The hatchback entered regardless, at a fair lick. I assumed he'd shoot across; but he slung the thing left when he was half over, and roared off with a hubcap rolling after him.",
#:   "The hubcap in the gutter is Exhibit C. It came off, according to the engineer, under a side load, as a left turn was made far too sharply for the speed. The turn was made by the defendant's van from the middle of a junction, and in that junction, as the signal log proves, the defendant's van should not have been. He had red.",
#:   "We are testing two surprises in one go. A crossing truck has a red signal, but it doesn't comply. That is the first. Its heading on entry says \"straight on\", and this is kept up until shortly before the ego's path, where it turns its wheels hard to the left. That's the second. It drives off without stopping.",
#:   "The light was with us and the street was empty but for a bus. It was on the other road, where, I need hardly say, it had a stop signal. I remember its side becoming its front, or its front becoming its side, for having sailed in against its signal it heeled round to the left so fiercely that the advert for yoghurt appeared to bulge.",
#:   "Dispatcher to all cars, reports of a stolen Astra, eastbound. It has failed to stop at the red by the library. It went in quick and straight, and the caller, who was sitting on green in a robotaxi, says that it then cut violently left inside the junction and has gone off along the canal at speed.",
#:   "A shout from the passenger seat was what saved us, \"he isn't stopping!\" He wasn't, red light or no red light. And just as I'd worked out that I could pass behind him, his motorbike keeled over to the left, as abrupt as a door slamming, and there he was going a different way. Twenty years I've driven, twenty.",
#:   "I dropped my ice cream. We were at the corner with the lights, and the lights on that side were red, I know my colours. A taxi came anyway. It came in the middle and then it went to the left so hard that the man in the back slid over like our cat on the lino. It didn't stop, it just went.",
#:   "How a forty-ton artic can be thrown about like that is beyond me, and I drive one. The lad had a red and carried on as if he hadn't. Next he must've seen the low-bridge sign, as he pulled left there and then, in the thick of the junction, trailer wheels off the deck, and kept on going up Station Road.",
#:   "At first the agent looks like an ordinary red-light runner going straight: phase red for 2.4 s at entry, constant speed, no yaw. Anyone who plans on that will pass behind it. Then, however, its yaw angle leaps to the left by around ninety degrees in the middle of the box, and it's moving away along a street nobody had predicted.",
#:   "Whose fault it is must decide the assurance. I have the green and I go gently. A little van of plumbers has the red and goes not gently. When he is before me in the crossroads he turns the steering to the left with such brutality that I hear all the tubes fall in his van; he doesn't stop for them.",
#:   "caption: guy on moped speedruns every traffic offence. runs the red (you can see it over his shoulder). goes like hes carrying on straight. then mid intersection just whips left with zero warning right acros the pov car and dips. he even had a takeaway bag in his teeth. pov driver: \"...\"",
#:   "Red on his pole, coach going through, then hard left.",
#:   "Moped ignores red, arrows in, breaks sharply left.",
#:   "lights said wait biker said no then flicked left",
#:   "It was red for the van, it came regardless, and where we'd put it down for straight on, it wrenched itself round to its left.",
#:   "Have the crossing truck go in against its red as though it meant to carry on, and then, without transition, snap left.",
#:   "His tyres yelped in the middle of the crossroads as he chucked the cab to the left, which is odd, since on red he'd no business there.",
#:   "V2 entered on red; its heading, which had been constant, then changed by about ninety degrees to the left within two metres of travel.",
#:   "If you're going to sneak over on red, do you have to throw the thing sideways to the left under everybody's noses as well?",
#:   "El semáforo was red for him, he didn't respect, and in the middle the pickup did like this with the volante, to the left, brusque.",
#:   "They found his load on the right-hand side of the crossing. Crates go on when a lorry doesn't. It hadn't waited at its red, that's the first thing, there's no doubt about it, the pedestrians had the green man. And it hadn't gone over, it had been put about to the left so sharply that the load said goodbye.",
#:   "From the top deck I could see both sets of lights. Ours, green. The other, red, and below it a people carrier that didn't know what red was for. I braced myself for it to flash across. It got as far as our bumper, and I lost it from my window, for it had flung itself leftwards and was legging it down Queen Street.",
#:   "Predicted: violation of the stop signal, followed by a straight traversal, occupancy of our lane from 2.1 to 2.9 s. Observed: violation as predicted, yes. At 1.8 s, however, the SUV's front wheels go to full lock, left, and it's out of the straight corridor and in another one, before us. The evasive path we'd planned led just there.",
#:   "There's a skill in it, I'll grant the lad that. To jump a red on a 125 is no skill, any fool can. But he was upright, going across, in third. And then from upright to footpeg-on-the-ground in no time whatever, a left that you could've cut yourself on, right across the front of my wagon, and gone.",
#:   "Quick, which way's he going? Don't look at his indicator, he hasn't used it. Don't look at his light, it's red, he hasn't used that either. Look at his front wheels. Straight... straight... and over they go to the left. That's a big bus and a small crossing, hence the squeal. You did well to stay put.",
#:   "The hot dog man gave evidence. He'd had the red lamp of the cross street before his eyes; a saloon had passed beneath it at a fair speed. \"I thought to myself, he'll be over in a second.\" He was not over. He'd changed his mind, or found his turning; the car heeled, all but lifted two wheels, and was away to its left.",
#:   "Dear Nephew, I'm well, though no thanks to a laundry van. We had our green. It had, therefore, a red, and paid it the attention that you pay my letters. Then when it was out in the middle, and one knew at least what to expect, it swerved off to the left as if stung. I've had a brandy since.",
#:   "Two faults in one movement, that's how the motorbike has failed. At the stop signal, which is red, he doesn't put the foot on the ground. After this he drives so as to go straight, everybody believes it. Then he falls onto the left side, a corner like in MotoGP, without the slightest announcement, and passes in front of our bonnet.",
#:   "On the junction camera the minicab's whole visit lasts three seconds. Second one: it slides in from the right under a lamp that's red, and has been for a while. Second two: it's heading for the other side. Second three: it isn't, it has broken away left at such an angle that you can see its hubcap set off on its own.",
#:   "My coffee went over the passenger. The robotaxi had begun to pull off on its green; from the side, out of a red, came a pickup; the robotaxi hesitated, as the pickup would be through in no time. Except that it wasn't going through. Halfway, with a jerk like a fish's, it turned left and presented us with its whole side.",
#:   "The scenario combines a signal offence with a late change of intention. The target passes its red phase at unreduced, constant speed and up to the given distance from the conflict point looks like through traffic. A step of ninety degrees to the left in its commanded heading follows. It does not halt or pick up speed at any time.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenario red-light-running; own code"
#: [slots]
#: actions = ["run-light", "turn-left"]
#: position = "crossing"
#: control = "signal"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 18.0
#: high = 42.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_SWERVE_DISTANCE"
#: low = 0.0
#: high = 5.0
#: unit = "m"
#: meaning = "how far before the place where their ways meet it turns"

param OPT_ADV_DISTANCE = Range(18, 42)
param OPT_ADV_SPEED = Range(5, 10)
param OPT_SWERVE_DISTANCE = Range(0, 5)

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    # Where no way goes straight on, it leaves its way before that bends.
    start = self.pose[2]
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < globalParameters.OPT_SWERVE_DISTANCE or abs(self.pose[2] - start) > 0.15
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 1.5708)
