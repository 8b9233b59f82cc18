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
