#: description = "The car pulls into the intersection, hesitates, and drives on."
#: rephrasings = [
#:   "A vehicle noses out, pauses in doubt, and then goes.",
#:   "The adversary stops halfway in and shortly after continues across.",
#:   "The crossing driver starts, waits, and starts again.",
#:   "Undecided, the car halts at the edge of the ego's way and then crosses it.",
#:   "The other car creeps in, stands a moment, and moves off before the ego.",
#:   "he pokes out, stops, can't make his mind up, and goes",
#:   "Vehicle 2 entered the intersection, paused momentarily, and continued.",
#:   "pulls in, short stop, on again",
#:   "He poked out into the crossroads, couldn't make up his mind, then carried on over.",
#:   "Vehicle 2 entered the intersection, paused momentarily as if uncertain, and resumed travel.",
#:   "Car into jct, dithers once, goes.",
#:   "Target enters the intersection, interrupts its motion briefly, then resumes and clears.",
#:   "The bus comes in the crossing, thinks a little, then goes further.",
#:   "One indecisive pause mid-junction, then proceeds; single hesitation, not repeated.",
#:   "He nosed in, faltered as though he'd forgotten where he was going, and then went on after all.",
#:   "He's in two minds, that driver; he's in the box, he's waiting, no, now he's going, let him clear.",
#:   "he pulled out into the junction, had a lil panic, then kept going",
#:   "A bus faltered for a moment in the junction before going over, causing alarm.",
#:   "You entered, you had second thoughts, and then you continued nevertheless; is that a fair summary?",
#:   "He came inside junction, thinking thinking, then only he went.",
#:   "Out he comes, has a think about it bang in the crossroads, then off across.",
#:   "Single momentary indecision of vehicle inside intersection prior to clearing.",
#:   "DRIVER ENTERS INTERSECTION, HAS SECOND THOUGHTS, GOES ANYWAY",
#:   "The motorcycle entered the crossroads, blinked, and went on.",
#:   "Crossing truck enters the junction, balks, then clears it.",
#:   "goes in has a wobble about it goes thru",
#:   "Target: junction entry, one short standstill, onward travel.",
#:   "The cab came out, stopped short, then thought better and drove over.",
#:   "SUV can't decide at crossroads: in... wait... okay, through",
#:   "Please build a crossing hatchback which enters the junction, gets cold feet in the middle for a second or two and then continues on its way.",
#:   "The lorry from the side street was already in the intersection when it stopped, apparently in doubt whether we would yield, and after that it rolled on through.",
#:   "Halfway out he saw the robotaxi, brought his motorbike to a stand, gave it a good long look, and rode on over the junction.",
#:   "V2 pulled forward into the intersection, stopped for approximately two seconds as its driver looked toward V1, and then went across in one go.",
#:   "This one is a waverer: he has come out to the middle, he's standing, he's looking at you, and now he's on his way again.",
#:   "The car comes in the crossroad, the driver makes a moment of doubt with the foot on the brake, and finally he passes.",
#:   "As I neared the crossroads a minibus edged out of the side road on my left and entered the junction. The lady driving plainly lost her nerve, for she pulled up in front of me. A second later she had collected herself and drove the rest of the way across.",
#:   "It's the pause that causes the trouble, m'lud. Had the defendant gone over without stopping, or waited, all would have been well. Instead he drove into the junction, came to rest there while he debated with himself, and then set off once more in the same direction.",
#:   "The actor simulates an inexperienced driver. It starts into the intersection at normal speed, brakes to a stop once inside because it is unsure about the right of way, holds for the configured time, and then resumes its route and leaves the intersection on the far side.",
#:   "I drive a forty-four tonner, I need to know what people are up to. This learner comes out of the turning, right, gets onto the junction, stops, you can see the panic on her face, and then off she goes to the other side as if nothing had happened.",
#:   "From the saddle you notice these things: the bus entered the crossing, its nose dipped as it stopped, and for a moment it just hung there, the driver evidently asking himself who was to go first. Then the doors of doubt closed and it trundled on through.",
#:   "Drives in, goes to pieces for a sec, then drives out.",
#:   "Minibus balked midway through the junction; presently it sailed on.",
#:   "One stutter inside the crossroads, one only, and off it went.",
#:   "She'd already got her Fiat out in the junction when doubt seized her; it stood a second or so and then took itself away.",
#:   "The adversary interrupts its passage through the conflict zone by one brief standstill, then proceeds along the original path without further interruption.",
#:   "Was it the robotaxi that made the biker pull up inside the intersection, only to let the clutch in again and clear off?",
#:   "Have a lorry drive into the intersection, brake to a short standstill as though it had doubts about us, and then finish its journey over.",
#:   "my nan does this all the time, gets into the junction, stops, goes ooh I don't know, and then off she toddles",
#:   "In the box the chauffeur has lost one second or two with standing and thinking, and only then he has driven out of it.",
#:   "I'd taken my foot off because I was sure the school bus would be over in good time. Then it wasn't: it was sitting in the junction with its brake lights on. I braked properly, and at that moment its lights went out and it drew away to wherever it had been going.",
#:   "Unit 2 entered the intersection, at which point the operator, unfamiliar with the locality, brought it to a temporary stop. The operator estimated the stop at one and a half seconds. Unit 2 was then driven onward and had vacated the intersection when Unit 1 reached the stop line.",
#:   "There's a particular sort of driver who only thinks about priority when he's already taken it. This one's out on the crossroads, and now the penny drops, so he stops. Stay back and let him work it out. That's right, he's worked it out, he's moving, and there he goes, clear.",
#:   "The truck's track has a kink in time, though none in space. It runs into the junction at six metres a second, shows nought for about two seconds when nearly on our line, and afterwards runs at six metres a second again until it is off the map. We tripped AEB in that interval.",
#:   "It was like when somebody forgets the words in the school play. The yellow car came onto the place where the roads cross and then it didn't know what to do, and everybody waited. And then it remembered and drove away, and Daddy said about time.",
#:   "A motorbike crossing our bows in the junction is nothing to write home about. But its front dipped, its rider's boots came down, and his helmet swung round to us like an owl's. I'd barely said \"what's he doing\" when the boots were up and he had gone the way he'd been facing.",
#:   "I do twelve hours a day in this cab, I can read people. Van comes into the junction, and I can tell from his wheels that he's had a fright, because they quit turning. I give him room. One Mississippi, two Mississippi, and they're turning again and he's off and away.",
#:   "What our statistics can't show is the effect of doubt. We therefore added an actor which drives into the junction, ceases moving at a point near the ego's path for a parametrised time, and only then completes the manoeuvre. Compared with the steady actor, collision rates doubled.",
#:   "By the time I reached the give-way line the coach was trundling off down the far road, so no harm done. A moment sooner, though, it had been stock-still in the crossroads, the driver craning at a signpost. He'd got himself in there without knowing which way he wanted, and had to stop and read.",
#:   "The horn was mine, I confess. It was meant for the pickup that had entered the crossing and then gone no further. Whether on account of the horn or not, its driver shook himself, so to speak, after hardly two seconds, and the thing rumbled on and left the junction free for me.",
#:   "They had reckoned on the little car going through in one breath. It took two: one to bring it out into the crossing, and, after a pause in which its driver seemed to consult some inner oracle, another to carry it off. Between the two breaths the van very nearly had it.",
#:   "Half in, foot off, foot on, through: crossroads nerves.",
#:   "Minibus in the box, stationary a tick, then away across.",
#:   "The biker's boots touched the junction briefly; then off he went",
#:   "A one-second hole in its progress, right inside the crossing, is all that distinguishes this coach from any other coach passing through.",
#:   "We both stood, we in front of the junction and she in it, until she got her courage together and left by the far arm.",
#:   "He went in like he owned it, sat there like he'd stolen it for a sec, and then toddled off out the other end.",
#:   "Let the truck's entry be interrupted, exactly once and only shortly, by an attack of doubt within the intersection; it shall then complete its route.",
#:   "I am saying go, go, and that Alto is standing inside the chowk scratching his head, then suddenly remembering and going off only.",
#:   "Speed trace of the crossing SUV: 22, 22, 0 for as long as a yawn, 22 again; the zero lies inside the junction.",
#:   "I could have sworn he'd stalled. There was the pickup, dead in the junction, and I was already reaching for the hazards to warn those behind. But the engine had never gone out, it was just him who had. He gave himself a shake that I could see from my seat, found the clutch, and drove on out.",
#:   "My co-driver keeps a notebook of them. Page four: lady, blue estate, goes in over the dotted line nice as you like; brake lights; looks left, looks right, looks at us; brake lights off; off up the other road. Duration of the looks, two seconds. We were on the pedal for all of it, with cement on board.",
#:   "The difficulty for the arriving AV is not that the crossing scooter enters, for it should be gone in good time. It isn't gone. It has broken off its passage inside the intersection, uncertain whether it may go on, and takes it up anew about one and a half seconds after. The AV must neither dash by nor wait for ever.",
#:   "Had it been a film I'd have thought somebody had paused it. Bus, junction, open mouth of driver: all still. My own car was the only thing on the screen that moved, and I stopped that. Whoever had the button pressed it again, and the bus with its driver travelled on over the crossing and out of the picture.",
#:   "Was there an old lady in the road? A dog? No, there was a sign, with nine villages on it, and it's placed so that you have to be in the crossroads to read it. The hire car in front of me had driven in, and read it, standing, down to the seventh; and having found his village he continued on his way.",
#:   "On the recording you hear Vehicle 1's driver say \"she's going\", then \"no she isn't\", then \"yes she is\". These three remarks correspond to the three phases of Vehicle 2's motion: it enters the intersection, it comes to a temporary stop there, and it moves off and clears. There was no contact.",
#:   "Look at the hubcaps, they never lie. Turning, so he's coming into the junction. Turning. Not turning, not now, and he's plumb in the middle of it. That's a man asking himself whose go it is. Wait for the hubcaps. There, they're turning, he's told himself it's his, and off he goes through the other side.",
#:   "I have felt very sorry for the boy on the L-plate moped. He entered well to the cross, and there came to him all the fears together, you could see it on the neck, and the moped died of speed until zero. I made him a sign with the hand. He breathed, he went, and he had passed.",
#:   "Nan was the one who started it. She'd rolled out on to the crossroads in the Micra and come over all unsure, so she stopped. The milk van stopped for Nan, and we stopped for the milk van. By the time that we three had finished stopping, Nan was sure again and halfway up the chapel hill.",
#:   "What the flies on its windscreen thought I can't say, but I know what I thought: that the lorry was broken down in the junction and we'd be late. It had come in quickly enough and quite suddenly had no more motion in it than a barn. A couple of heartbeats, that was all. The barn hooted and drove out.",
#:   "Dispatch from unit six, disregard the obstruction on Park and Ninth. When I called it in there was a box van at rest in the middle of the intersection with the driver looking every which way. Took him maybe two seconds from when I keyed the mike to make up his mind. He's proceeded through, junction's open.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["hesitate"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -4.0
#: high = 26.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 8.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = -3.0
#: high = 2.0
#: unit = "m"
#: meaning = "how far beyond where their ways meet it pauses"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.4
#: high = 1.5
#: unit = "s"
#: meaning = "how long it pauses"

param OPT_ADV_DISTANCE = Range(-4, 26)
param OPT_ADV_SPEED = Range(4, 8)
param OPT_STOP_DISTANCE = Range(-3, 2)
param OPT_STOP_TIME = Range(0.4, 1.5)

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory) until self.pose[3] < 0.05
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
