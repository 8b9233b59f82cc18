#: description = "The car approaches at a normal speed and makes a last-second right turn."
#: rephrasings = [
#:   "A vehicle comes on as if to go straight and abruptly swings to the right.",
#:   "The adversary decides at the final moment to turn right.",
#:   "The other driver yanks the wheel to the right in the middle of the junction.",
#:   "Late and without signalling, the car turns off to its right.",
#:   "The approaching vehicle suddenly hooks right into the road the ego is taking.",
#:   "looks like he's going straight and then he chucks it right at the last second",
#:   "Vehicle 2 initiated an abrupt right turn at the last moment.",
#:   "straight, straight, then sudden right, no indicator",
#:   "he came along at a perfectly normal lick and then hung a right at the very last moment, no warning at all",
#:   "Vehicle 2 approached at an ordinary speed and executed a right turn at the last possible instant.",
#:   "MC normal appr., then late R turn.",
#:   "The target approaches at normal speed; its right turn is initiated only at the latest feasible point.",
#:   "The bus drives normal, I think straight, but in the last moment he turns to the right.",
#:   "Late-decision right-turner: no slowing ahead of time, heading change triggered right at the junction mouth.",
#:   "The truck had come on as though going straight, and only when it was nearly past the corner did it wrench itself right.",
#:   "Doesn't look like he's turning, does it? And yet, blink, off to the right, left it till there was no road left.",
#:   "he was deffo going straight and then nope, random right at the very end",
#:   "A coach everyone assumed was going ahead veered off to the right with no time to spare",
#:   "You gave every impression of continuing, and only at the mouth of the turning did you swing right?",
#:   "Coming straight straight, then last minute only he is taking right, what to do",
#:   "Bike's going straight on, I'd have bet my house, and at the death he ducks off right",
#:   "Late unannounced right turn of approaching vehicle at unreduced speed",
#:   "Truck decides to go RIGHT at the last possible moment",
#:   "The van hooked off rightward at the death.",
#:   "SUV drives up normally, then snatches a right at the final instant.",
#:   "Ordinary speed, no hint, and abruptly it peels off right.",
#:   "Biker, steady approach: cranks it over to the right terribly late.",
#:   "He comes normal, and when it is almost too late he goes right.",
#:   "Right turn? He only decided on it when he was there!",
#:   "The bus had been coming on at the usual town speed, and its front wheels went over to the right only when the corner was upon it.",
#:   "Have the other car approach as if nothing were to happen, and let it begin a sudden turn to its right at the latest possible moment.",
#:   "Up to the junction the pickup held thirty and looked for all the world a through vehicle; then its driver flung it round to the right.",
#:   "An ordinary approach, you'd say, nothing to see, until the scooter rider ducks into the street on his right with no room left to do it.",
#:   "Signal? Not on your life. That lorry arrived at the same rate as everyone and then swung off right when he was practically past the opening.",
#:   "The trajectory is straight at constant speed until shortly before the conflict point, where the yaw angle changes by 90 degrees to the right.",
#:   "My statement is that the taxi neither slowed nor indicated on the way up to the crossroads. I took it that he would go over. When he had as good as reached me he cut his wheel to the right and went off into the other street.",
#:   "This is why I teach you to cover the brake. That coach was doing a perfectly regular speed, no blinker, in a straight line, and at the very mouth of the junction its driver remembered where he was going and heaved it round to the right.",
#:   "We were discussing whether it was a Polo or a Golf when it made us both shut up. It had come along quite calmly, as people do when they're going straight on, and out of that calm it whipped to the right with a squeal, at the point of no return.",
#:   "V2 was travelling at a speed consistent with the surrounding traffic and its path offered no indication of an intended manoeuvre. Immediately before the point of conflict its heading changed abruptly clockwise, and V2 departed to its right. Reaction time for V1 was below one second.",
#:   "Grandad says the man in the van must have a bad sat nav. He drove to the crossing like everyone does and then he must have heard it say right, because he spun the wheel that way so late that the boxes inside went bang.",
#:   "Normal approach, nothing doing, then hard right at the very mouth.",
#:   "SUV comes up at everyday speed, bangs a right impossibly late.",
#:   "No clue given till the corner's edge: motorbike dives right.",
#:   "The lorry bowled along like any other until it was on top of the turning, whereupon its driver spun the wheel and off it went right.",
#:   "guy was doing the limit, no blinker, dead straight, and like half a second before it's too late he yoinks it right",
#:   "Target speed shall be constant and typical for the road; a ninety-degree clockwise heading change is commanded at the last point where it can still be executed.",
#:   "You'd swear that bus was going on, wouldn't you, at that steady lick? And there, far too late, he's thrown it into the right-hand turning.",
#:   "Have the scooter come on at an unremarkable speed, so that everybody thinks it will carry on, and turn it right when there's hardly room left.",
#:   "Total ordinary speed he was having, I thought he's going ahead only, then in the last fraction he has folded to right side.",
#:   "I'd have staked my licence that he was going over. He'd come up to the crossroads just like the cars before him, neither hurrying nor holding back, not a wink from his indicators. Then there was the side of a van where the front had been, all leaning over, as he'd made up his mind for the right-hand road when he was practically past it.",
#:   "It is agreed between the parties that the defendant's motorcycle was travelling at an appropriate speed. What the claimant complains of is what came at the end. With no signal and no reduction of speed, and at a distance from the turning that left no time for anyone, the defendant banked into it to his right.",
#:   "You can hear the satnav lady on our own film, she's saying continue. I expect the lady in the other car said something else. It had been rolling towards the crossing as calm as milk, and at the point where I'd already forgotten about it, its nose was jerked away to the right, tyres squealing, and it was gone up Bell Hill.",
#:   "What made this hard for the tracker was that there was no tell. Speed twelve metres per second throughout, yaw rate nil, right up to the frame in which the bus was at the mouth of the side road. In the following frames yaw jumps to the clockwise limit and it leaves us by the street on its right.",
#:   "Grandma always says folk should know where they're going before they get there. The coach man didn't. He came along the same as all the others do, and when he was there, properly there, he must have seen the sign for the zoo, because he heaved it round to his right and all the children's heads went the other way.",
#:   "V2's approach was uneventful. V2 was being operated at thirty miles per hour in a thirty-mile-per-hour zone and bore no signal. With its front bumper level with the near corner, V2 was steered sharply to its right, a movement for which V1's driver, who assumed it was a through vehicle, was unprepared.",
#:   "We bikers look at front wheels. That pickup's front wheels had been dead ahead from as far as I could see it, and it was humming along no different from anyone. Then they flicked over, to his right, when he was as good as beyond the opening, and I watched forty years of rust go round that corner on its door handles.",
#:   "I have taken a picture of the flower bed. This lorry arrives to the junction like all the world, good speed, no lamp blinking, and one thinks: he goes straight. In the ultimate moment the chauffeur pulls all to the right, so the back wheels pass on the tulips, and he enters in the other street.",
#:   "There's late, there's very late, and there's what I saw this morning, lads. Artic, steady thirty, not a flicker on his indicators, I've got him down as straight on. He's all but run out of junction when the cab swings to its right, and I don't know how the trailer made it round.",
#:   "You ask for the reason our shuttle stopped. It had predicted, as I would have, that the taxi would go on, since it came up neither fast nor slow and in the middle of its lane. Turning right at that stage was not on the menu any longer; the driver ordered it all the same, with a whirl of his arms.",
#:   "There are people who decide with their heads and people who decide with their elbows. He'd been driving towards the junction as evenly as a man in his own corridor, and she'd let her eyes go back to her mirror. In that instant the elbows went up, and the big car pivoted to its right at a corner it had already given away.",
#:   "Carrying on, carrying on, then a whip to the right. Gone.",
#:   "Even speed, no clue, corner all but missed, rightward lunge.",
#:   "He'd nearly passed his right turn when he flung the bus round it.",
#:   "Anyone would have put that taxi down as going on; its side, not its front, was what it showed us, too late, on its way into the right-hand street.",
#:   "Approach speed nominal, no indicator, no deceleration; at the last feasible metre command a heading step of minus ninety degrees and let it drive off that way.",
#:   "ppl saying i shouldve known he was turning. HOW. normal speed, dead centre of the lane, then the wheel goes right about a foot before the corner's over",
#:   "Like all lorries it was coming, medium speed, no signal, I have started moving; when there was no more time it has cut inside the road on its right.",
#:   "Your mistake was to trust the pace. It said the van was going through; then at the death its front wheels told you right, and off right it went.",
#:   "The pickup used up the whole of its approach in being ordinary and the last two feet of it in hurling itself round to its right.",
#:   "There's a stop for the milk lorry in every household but ours, and he must have remembered it all of a sudden. He'd been bowling along to the crossroads at his usual lick; I'd let my clutch in, seeing him as good as over. The churns told me otherwise. They all slid to the left with a boom, and lorry and churns went off down the road on his right.",
#:   "In frames one to ninety the object's motion is uniform and its predicted exit is \"straight\", probability 0.97. From ninety-one its yaw rate saturates clockwise, and that's four metres before the geometry would've made the manoeuvre impossible. The object, a motorcycle, leaves through the arm on its right-hand side with our brake pressure at its maximum.",
#:   "I was asked at the inquest what indication there'd been. None. I was asked whether the vehicle had slackened. It had not, it had approached as one approaches a green light on a road one knows. I was asked what then made me shout. It was seeing the coach lean over to its left, swinging away to the right, with so little road to do it in.",
#:   "You know how a spaniel goes past the gate and then comes round on itself because it's smelt something? I was pumping up a tyre at the corner. A grey saloon came along at the speed they all do, past me, past the sign, nearly past the turning. Then it smelt something, and it was round to its right so sharply that a hubcap rolled up to my pump.",
#:   "Two sorts of people were surprised. Those in the bus, who went down like skittles to the left; and us, who'd been watching it drive up to the junction at its accustomed thirty and had read STATION over its windscreen. The station's straight on. The bus, with hardly a yard of corner in hand, had been hauled off to the right.",
#:   "The kerb took a bite out of his rear wheel, it's in the photograph. That's on the inside of the corner, his right. He would've had to begin ten metres earlier to get round it decently, but ten metres earlier he was cruising up just like a man who means to go over, hands at ten to two, and we'd all believed him.",
#:   "Lane assistant says left, navigation says straight, brother-in-law says right. I wasn't in that car but I could tell the moment at which brother-in-law spoke. Up to it, a family saloon at fifty, calm. After it, four arms in the windows, screeching, and the whole family heeling over and off into the road to their right, when the junction was practically behind them.",
#:   "It was the wink of his indicator that undid us, in that there wasn't one. The robotaxi waits for the wheels. The wheels of the lorry were straight, and its speed was what it'd been since the bridge; they remained so until its cab was abreast of the side street. Only then were they wrenched over, and it went in on its right, rear axle in the air.",
#:   "He's a good boy, my Deepak, he's always telling the story against himself. With normal speed he was going on his motorcycle to the crossing, thinking of cricket. Then he saw the tea shop, and it was on the right. No indicator, no slow, in the last moment he laid the machine down to that side, and the taxi people were praying.",
#:   "V2's line of travel and rate of travel, both unvarying, led V1's operator to conclude that V2 would proceed through. V2's yaw marks commence eight feet short of the far curb line. They are those of a right turn executed within a radius for which the design speed is nine miles per hour; V2's was twenty-eight.",
#:   "A man may walk past his own front door if he's thinking, and so it was with the driver of the long black car. He came on, at the sober pace of a man with somewhere to be, and they took him for one who'd be carried beyond them. Then his house called to him. The bonnet flew round to his right and the corner swallowed him.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["turn-right"]
#: maneuver = "left-turn"
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
#: meaning = "how fast it approaches"
#: [[parameters]]
#: name = "OPT_SWERVE_DISTANCE"
#: low = 2.0
#: high = 14.0
#: unit = "m"
#: meaning = "how far before the place where their ways meet it turns"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_SPEED = Range(5, 10)
param OPT_SWERVE_DISTANCE = Range(2, 14)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < globalParameters.OPT_SWERVE_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED, -1.5708)
