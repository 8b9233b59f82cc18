#: description = "The oncoming car stops, hesitates, and then comes on while the ego goes around the obstacle."
#: rephrasings = [
#:   "he stops, can't decide who goes first, then he goes",
#:   "Vehicle 2 halted in the opposing lane and then resumed travel while Vehicle 1 was passing an obstruction.",
#:   "opposing veh: stop, dither, goes",
#:   "The oncoming target comes to a temporary standstill before the narrow place and then continues toward the VUT.",
#:   "The bus in front makes a stop, it is not sure, and then it continues.",
#:   "A cyclist coming the other way puts a foot down, wavers, and rides on.",
#:   "First the lorry opposite waits for us, then it doesn't.",
#:   "Undecided at the bottleneck, a van pauses before it pushes on.",
#:   "I was halfway round the roadworks when the fella coming the other way stopped, dithered, and then rolled on at me anyway",
#:   "As V1 passed the obstruction, the oncoming vehicle halted, appeared undecided, and then continued toward V1.",
#:   "Opp. bus: stops, unsure, then comes on while we pass obstacle.",
#:   "During the VUT's evasion of the obstruction the oncoming target comes to standstill, waits briefly and continues its approach.",
#:   "When I go around the broken car, the bicycle from front stands, thinks, and then comes against me.",
#:   "Oncoming actor in the narrow passage: full stop, dwell, resume at normal speed while the SUT is still alongside the blockage.",
#:   "The rider coming the other way had stopped and wavered while they squeezed past the wreck, and then all the same he came.",
#:   "He's stopped for you while you get round that skip, or has he? He can't decide... no, he's moving again, hold it.",
#:   "i was going round the parked car and the one coming stopped, was like ummm, then kept coming anyway",
#:   "A van meeting a driver at a blockage stood, dithered and then proceeded while she was still out in the road",
#:   "You stopped, you were undecided, and you then came on although my client was already going round the obstruction?",
#:   "I am going around the blockage, opposite fellow stopped, thinking thinking, then he also is coming",
#:   "Make your mind up, pal, I'm round the skip already; he stops, he dithers, and then he trundles on at me",
#:   "Indecisive opposing traffic during obstacle bypass: halt, dwell, renewed approach",
#:   "Oncoming cyclist stops, dithers, then comes on while I'm PASSING the obstacle",
#:   "The lorry facing us stalled its decision, then nudged on as we rounded the blockage.",
#:   "Van facing us halts at the narrowing, wavers, then advances anyway.",
#:   "we pass the skip, oncomming cyclist stops dithers rides on at us",
#:   "Opposing bus: standstill, moment of doubt, under way again. Ego bypassing.",
#:   "Have the lorry opposite pause undecided, then roll on toward us.",
#:   "First he waited for us to get past the digger, then he didn't.",
#:   "While the robotaxi was working its way round a broken-down milk float, a saloon from the other direction stopped, thought it over, and came on all the same.",
#:   "During the bypass of the stationary obstacle by the VUT, the opposing target decelerates to zero, dwells for a moment and takes up its approach again.",
#:   "You're out round the parked lorry and she's stopped for you, lovely. Or not so lovely: she's um-ing, she's ah-ing, and now she's driving at you.",
#:   "I was passing the place of works when the moto in face stopped itself, hesitated some instants, and then restarted toward me.",
#:   "Did the coach wait for us to finish going round the wreck? It did come to rest, it seemed in two minds, and then it pushed forward.",
#:   "A pickup stood there as though giving way at the fallen tree; only once we were alongside did the driver, after some dithering, set off toward us.",
#:   "There is a skip outside number forty, so you've got to use the other side for a few yards. A lady in a hatchback was coming the opposite way and stopped. I raised a hand to thank her; she looked left, looked right, couldn't decide, and then proceeded towards me after all.",
#:   "Requested for the regression suite: obstacle bypass with indecisive opposing traffic. Actor reaches standstill well before the obstacle, which our negotiation module takes as a yield. After a short dwell it resumes its original speed in our direction, while we are still out round the obstacle. Re-plan came late and was uncomfortable.",
#:   "My cab was half past the fallen scaffolding when I saw the artic's nose dip. He'd stopped, and I could see him rubbing his chin up there, wondering whose turn it was. Then there was a hiss of air and the big thing moved off in my direction, with me still sticking out.",
#:   "Vehicle 1 had begun to pass a disabled vehicle. According to both drivers, the bicyclist approaching from the opposite direction put a foot to the ground and looked uncertain. The bicyclist then remounted and continued toward Vehicle 1, each party supposing that the other was going to wait.",
#:   "They have a name for it in the trade, the double think. The oncoming minibus draws up as you're steering round the obstruction. A second passes, perhaps two, in which nobody knows who goes. And just when you've made up your mind that it's you, the minibus starts up and comes on.",
#:   "Opposite scooter halts as we skirt the skip, wavers, then rides at us.",
#:   "Let an oncoming coach stop undecided, then advance while ego rounds the wreck.",
#:   "passing roadworks, cab opposite stops, umms, then comes anyway, cheers pal",
#:   "As we were steering round a stranded caravan, a pickup from the other side drew up, seemed to weigh the matter for a moment, and proceeded to meet us.",
#:   "While the VUT deviates around the blockage, the opposing target brakes to rest, remains so for an interval, and then resumes travel in the VUT's direction.",
#:   "From opposite, one bicycle fellow has put his foot down seeing me go round the fallen tree, he is confused, and then he is pedalling straight at me only.",
#:   "The van driver in face has stopped himself, I was already contouring the broken lorry, he did not know what to do, and at the end he advanced.",
#:   "He's pulled up to see you round the rubbish truck, has he? Don't be sure, he's wondering about it... and there, he's rolling up to you again.",
#:   "After coming to rest, in evident doubt, the motorcycle facing my client did set off in her direction, and this with her vehicle still alongside the obstruction.",
#:   "I'd committed myself, you see. There was a horse trailer broken down on our side and I was out around it, in front of an oncoming bus that had stopped for me. Or I believed it had. I saw its driver shrug at his passengers, look at me, look at the trailer, and then its front began to swell up again in my windscreen.",
#:   "V1 was passing a parked mower and had moved partly across the centerline. V2, a truck approaching from the opposite direction, came to a complete stop sixty feet short of it. V2's operator stated he was \"not certain who had the right\". After about two seconds V2 moved forward again toward V1.",
#:   "It takes two to have a misunderstanding, and the other one was a man on a postal bike. I'm halfway by the cement mixer, he comes up from the front and gets off the saddle. We look at one another. His mouth opens and shuts. And then up he gets and comes pedalling along at me.",
#:   "Issue: negotiation at the bottleneck. Opposing SUV reaches v = 0 in front of the narrow bit while ego is going round the stopped vehicle. Standing time about 1.5 s, which is less than our yield-confirmation timer. Then it starts and continues on its original path, towards ego. Result: nose to nose beside the obstacle.",
#:   "The scaffolding had eaten half the street, and it was her turn; the lorry facing her said so by standing still. But she had not finished creeping past the poles before its lamps nodded. Doubt had come over it, then, so it seemed, impatience. It was under way again and it was under way to her.",
#:   "I have a pet hate, and it's waverers. A lady in a red hatchback the other day: she's coming my way, there's a dustcart I'm going around, she stops. Bless her, I think. She creases her forehead for a second or two and, instead of letting me finish, drives on up as though I'd been a hologram.",
#:   "Could you simulate how people behave at our building site? The ego swings out around the excavator. A car from the opposite direction pulls up, and nobody knows what's going on, its driver included. In the end, a little before the ego has finished, the car starts forward and comes along as it was coming before.",
#:   "Behind me the children were counting diggers, so I was slow in going round the last of them. A motorbike was approaching from over there, and he'd got both boots on the ground for us, visor up. Visor down. Visor up. He couldn't decide who was who. Then both boots left the ground and he was on his way to us.",
#:   "I write as a trucker and it's the hesitation that kills you. The coach opposite came to a stand, fair enough, I'd got my whole rig out around a burst main. Then there was a long nothing. Had he remained where he was I'd have been through in five seconds; but he got cold feet, let the brake off and trundled on towards my cab.",
#:   "As far as I could see from my saddle, the silver saloon did everything in instalments. It approached; when it saw the robotaxi out round the skip it stopped. That was the first. Then it did nothing at all, and you could feel it thinking. The last one was that it came on up the road regardless.",
#:   "Oh, the face on him! I'm going round Mrs Pugh's broken-down Honda with my Zimmer on the seat beside me. This young man coming down the hill stops his taxi. He dithers, he points at me, points at himself, scratches his ear. And what does he do in the end? He comes on down, and me not half past her yet.",
#:   "Skip on my side; van opposite halts, dithers, comes regardless.",
#:   "Round the wreck we go; rider opposite stops, ponders, proceeds.",
#:   "he stopped 4 me at the roadworks, umm'd, then didnt anymore",
#:   "While the AV rounds the parked lorry, let the bus facing it come to a stand, be of two minds, and then get rolling at it after all.",
#:   "Twice I was certain, once that he'd wait, for he was at a halt, and once that he wouldn't, since I was out by the digger and his wheels were turning again.",
#:   "The courtesy of the minibus coming the other way lasted as long as I needed to get out past the fallen tree, and was then withdrawn.",
#:   "Opposing target: decelerates to nil upstream of the obstruction, remains at nil for the set dwell, re-commences travel at approach speed, the VUT being engaged in the bypass.",
#:   "A foot went down on the tarmac, so I steered out round the bins; the foot went up on its pedal again, and there was the bicycle, rolling toward me.",
#:   "Think of two people at a narrow door: the cab over there stood still, neither of us sure, me halfway past the skip, and then it was he who walked through.",
#:   "There were three lots of headlights in that film. The first come nearer, that's a car in the opposite lane on its way to us. The second stay the same, for the blink of a couple of eyes, as we start to pass the burnt-out van. The third get nearer again, and by then we're on the wrong side of the road with nowhere to be.",
#:   "I had the skip on my nearside, and my wife said \"he's letting you.\" He was certainly stationary, this chap in the jeep, and his hand was off the wheel, though not to wave, he was scratching his chin. So out I went. The chin must've told him something, as the jeep set off, and we met with the skip beside us.",
#:   "It isn't true that V2 failed to stop. It stopped. The footage puts it at 0.0 for one and a half seconds, on its own side, with V1 drawing out past the broken-down tractor. It is what followed the one and a half seconds that shut the passage: V2's operator, who said he'd been unsure whose turn it was, let it go forward again.",
#:   "In the mirror of a shop window I watched them both. Our car went out around the ladder. The motorbike facing us had his boots on the ground by then, engine ticking. He looked to the ladder, to us, to the ladder. I thought, well, thanks. Then the boots were off the ground, and it was us who had to shrink.",
#:   "A stopped oncoming vehicle is not the same thing as one that's giving way, that's the point of this test. It stops, quite without being asked, as the ego starts around the obstacle. The ego goes on. Not having made up its mind for a second or so, the other does what it'd have done anyway, it comes through. Now hold back or squeeze?",
#:   "One hears the lorry's air brakes sneeze, that's the halt. One hears nothing for a moment, that's him thinking. And one hears the brakes let go and a diesel take up, that's what he thought. It would not have mattered, only that I was passing a hay cart the while and had all four wheels on his half of the lane.",
#:   "Our neighbour Mr Petrov is a kind man but slow in his head, he says so himself. He met me by the gas works' hole. He stood with his Lada, so I went out around the hole. \"Then I could not remember,\" he told my husband, \"if I have waved her or only wanted to.\" So he drove on, straight up to where I was.",
#:   "Had it been rude I could have coped. A rude coach keeps coming and you stay behind your dustcart. This one lost its way and stood, meek as milk, so I was out past the dustcart's cab before it found courage again, and a coach with courage fills a road. I went backwards, all the way in behind those bins.",
#:   "I was the dispatcher on shift. Car 9 says, I'm getting round the stranded horsebox, opposing traffic has pulled up. Good. Car 9 says, he's sat there, I don't think he knows what he wants. Then Car 9 says a word, and says, he's decided, he's under way again, right at me, I'm stuck out here by the horsebox.",
#:   "Logged by the safety operator: nudge manoeuvre around double-parked truck initiated as the opposing van's speed read zero. Confidence \"yielding\" 0.9. After 2.1 s its speed was no longer zero, and the sign of its intent wasn't to be mistaken, as it came on at its former pace. Takeover, wheel in, stopped alongside the truck.",
#:   "I put out for the fallen scaffolding and the girl on the bike put a toe down, over on her side. Nobody else on the street. I smiled, she half smiled. A pause came, the sort you get on the telephone, when each says \"no, you\". Then she started to pedal up to me, and I, who'd taken it that the \"no, you\" was hers, was square in her way.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "hesitate"]
#: position = "oncoming"
#: maneuver = "bypass"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.0
#: high = 7.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 25.0
#: high = 55.0
#: unit = "m"
#: meaning = "distance to the ego at which it pauses"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.5
#: high = 2.0
#: unit = "s"
#: meaning = "how long it pauses"

param OPT_ADV_SPEED = Range(3, 7)
param OPT_ADV_DISTANCE = Range(25, 55)
param OPT_STOP_TIME = Range(0.5, 2)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until self.pose[3] > 1.5 and gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, 0.7) until self.pose[3] < 0.05
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
