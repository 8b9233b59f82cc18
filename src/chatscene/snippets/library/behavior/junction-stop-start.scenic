#: description = "The car crosses the intersection in small jerks, stopping again and again."
#: rephrasings = [
#:   "goes a bit, stops, goes a bit, stops, all the way over",
#:   "Vehicle 2 proceeded through the intersection in a stop-and-go manner.",
#:   "kangaroos across: roll, halt, roll, halt",
#:   "The target traverses the junction slowly with repeated standstills.",
#:   "A beginner is crossing, his car stops every metre and starts again.",
#:   "A learner bunny-hops over the crossroads.",
#:   "The lorry shunts forward a little at a time, pausing between each move.",
#:   "Stuttering along at low speed, the bus needs several goes to get across.",
#:   "He kangarooed all the way over the crossroads, kept stopping and rolling on and stopping again.",
#:   "Vehicle 2 moved through the intersection in a series of short advances with repeated full stops.",
#:   "Truck hops thru jct: go-stop-go-stop-go.",
#:   "The target crosses the junction intermittently, with several successive halts.",
#:   "The car goes one meter, stops, goes one meter, stops, so over the whole crossing.",
#:   "Repeated stop/go cycles inside the intersection (3+ halts), not one hesitation and not a steady crawl.",
#:   "It lurched, and stood, and lurched again, and so by fits and starts it got itself across.",
#:   "Learner in the junction, he's bunny-hopping, stopping every couple of yards, give him plenty of space.",
#:   "this truck was stop go stop go stop go the whole way over the intersection im dying",
#:   "The van hiccuped over the crossroads, halting four or five times on the way.",
#:   "It did not halt once but repeatedly, moving a yard or two between each halt, until it was over the junction?",
#:   "Crossing the junction he go a bit, stop, go a bit, stop, very jerky driver.",
#:   "Like he's learning the clutch, hop, stop, hop, stop, right over the crossroads.",
#:   "Intermittent intersection transit with multiple successive halts.",
#:   "LEARNER BUNNY HOPS ACROSS THE ENTIRE INTERSECTION",
#:   "The bus hiccuped over the junction yard by yard.",
#:   "Learner lurching over the crossroads, stall, hop, stall, hop, over.",
#:   "Create a lorry that jolts through the junction with countless little halts.",
#:   "The crossing van kept seizing up and shuffling on. Every. Two. Metres.",
#:   "Why does that bus cross in dribs and drabs, freezing each time?",
#:   "El coche cruza a saltitos, so: little jump, stop, little jump, stop",
#:   "Instead of getting on with it, the pensioner in the Polo took the intersection in nibbles, coming to rest after each one to look about him.",
#:   "Vehicle 2's progress over the junction consisted of six bursts of about two metres apiece, each followed by a complete standstill of roughly a second.",
#:   "The clutch must have been shot, for the removal truck bucked its way through the crossroads a yard at a go, and stood between the bucks.",
#:   "Mummy counted them: the green car stopped one, two, three, four, five times before it was over the crossing, and each time it went boing.",
#:   "The coach needed the best part of a minute to clear the junction, so often did it nudge ahead, pull up, nudge ahead and pull up once more.",
#:   "Log shows sawtooth velocity for the crossing actor inside the box: 0, 2, 0, 2, 0 m/s and so forth until it has passed the conflict area.",
#:   "It was her second lesson, poor love, and we met her at the crossroads. The car would bounce forward half a length, die on her, bounce forward again, die again, and in that manner she laboured over the whole of the junction while my bus full of passengers looked on.",
#:   "The subject vehicle was required to wait for an unusually long interval. A goods vehicle with a faulty throttle was passing over the intersection from the right in a string of tiny surges; after every one of these it came to rest, and no two pauses seemed to be of the same length.",
#:   "You'd think a driver would either cross or not cross. This chap in the delivery van did both, over and over: forward a touch, on the brake, forward a touch, on the brake, the whole way to the other side, with his parcels thumping about in the back.",
#:   "Please build me a nervous crosser. It enters the intersection slowly, comes to a standstill after a metre or two, tries again, comes to a standstill again, and that goes on and on while our robotaxi approaches, so that nobody can predict when the path will be free.",
#:   "In my country we say he drives like he has hiccups. The old Lada was passing from left to right over the crossing with small kicks, and after every kick it remained still for one moment, maybe seven times in total, and I am sitting there and cannot go.",
#:   "Bus over the crossroads in instalments: twitch, stand, twitch, stand.",
#:   "he crossed in like nine goes, kept freezing",
#:   "Crossing lorry keeps jolting on, keeps stopping. Still in the box, over.",
#:   "Each time we thought the hire van would finally be out of the junction it sat down again, having gained about a yard on its previous resting place.",
#:   "Count with me, because he's going to stall: that's one, off he jerks, that's two, another hop, three, and he's only half over the crossing.",
#:   "Vehicle 2 required eight separate movements, with the wheels at rest between them, to get from the north leg of the intersection to the south leg.",
#:   "The brakes of the crossing coach sighed, and sighed, and sighed again, for it was making its way over the junction a pace at a time.",
#:   "Target profile in conflict area: pulses of 0.8 s at 2 m/s separated by standstills of 1 s, repeated until the rear end has left it.",
#:   "Why that tourist's camper twitches, waits, twitches, waits all through the crossing nobody knew, but the robotaxi had to stand there until the last twitch was done.",
#:   "I could draw you the graph of it. The truck came into the crossroads at a trickle, and then it was a staircase: a little way, flat, a little way, flat, and so on over to the opposite side. I'd start to release the clutch on every flat bit and have to grab the handbrake on every rise.",
#:   "Her brake lights were like a lighthouse. On, and the little Fiat would be standing. Off, and it would leap perhaps a metre further over the crossing. On again. We watched it do the whole junction that way, from the chemist's to the bank, and my father said in his day they took the licence off you.",
#:   "There was a melon lorry in front of the temple crossing, coming from left. Driver was changing his mind at every foot. He would push a little, stop, look at the cows, push a little, stop, look at us. Five, six times like this he did before the road was empty of him.",
#:   "Sim request: I need the conflict zone occupied for a long time by somebody who can't be predicted. The bus enters, moves a little, freezes; moves a little, freezes; and that's how it gets to the far side, so that at no point can our car tell whether the present standstill is the last one.",
#:   "The learned magistrate asked whether the car had been stationary or moving when my client sounded her horn. It's a fair question with no fair answer. It had come to a stop in the intersection for the fourth time, or was lurching forward for the fifth. There were to be several more of each before it was clear.",
#:   "Poor man, he must have had the wrong shoes on. I was waiting by the memorial with my shopping trolley and he came out of Church Street in a very smart car. Hop, it went, and stood trembling. Hop, and stood trembling. I'd crossed myself, gone into the post office and come out again before he'd hopped the lot.",
#:   "You get clutch judder in an old Leyland, but this was more than judder. The tipper would heave itself on by half its own length, come down on its springs and stop dead, then heave itself on again. It went over the whole of the junction like that, dropping a bit of gravel at every station of the cross.",
#:   "Traffic desk, one for the eleven o'clock. We've a removal lorry taking the Five Ways junction in bites. It goes a car's length, holds, goes another, holds. Callers say he's been doing it ever since he left Park Road, and he isn't all the way over yet, so allow extra time from the east.",
#:   "Of course I honked. What would you do? First stop, I thought, right, he's letting me go. I started, and he moved. Second stop, the same thing again. By the fifth we were both a bit further on and neither of us was any wiser, and that blooming minibus still had half the crossroads in front of it.",
#:   "What the rear passengers of the AV remember is the nodding. The crossing bus was full of people standing up, and they all nodded together, forwards when it pulled up, backwards when it set off. They must have nodded a dozen times between one side of the intersection and the other.",
#:   "He had the wheel in both fists, the clutch in a panic, and the whole of the market-place for an audience. The car sprang; it died. He revived it and it sprang once more, and once more it died. So, between a series of resurrections, he was brought at length to the opposite street.",
#: ]
#: adversaries = ["car", "truck", "bus"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["slow", "hesitate"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 5.0
#: high = 25.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 2.0
#: high = 3.5
#: unit = "m/s"
#: meaning = "how fast it creeps"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 1.0
#: high = 2.0
#: unit = "s"
#: meaning = "how long it rolls each time"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.6
#: high = 1.0
#: unit = "s"
#: meaning = "how long it stands in between"

param OPT_ADV_DISTANCE = Range(5, 25)
param OPT_SLOW_SPEED = Range(2, 3.5)
param OPT_ADV_PERIOD = Range(1, 2)
param OPT_STOP_TIME = Range(0.6, 1)

advTurn = "straight"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advMeeting) < 10 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_SLOW_SPEED
    while True:
        do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED) for globalParameters.OPT_ADV_PERIOD seconds
        do BrakeOnPath(advTrajectory) for globalParameters.OPT_STOP_TIME seconds
