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
#:   "Bus at the crossing: hop, halt, hop, halt, all the way over.",
#:   "lorry going thru the junction like a buffering video. go stop go stop",
#:   "Van, crossroads: twitch forward, freeze, twitch forward, freeze, nine times.",
#:   "I counted seven separate sets of brake lights off the one little saloon before it had finished getting from one side of the crossroads to the other.",
#:   "The crossing coach gave us a window of hope after each of its little rests, and took it away with the following yard, right through the intersection.",
#:   "Somebody's first day with a clutch, clearly: the hatchback's head nodded its way over the junction, a yard and a nod, a yard and a nod.",
#:   "Throughout its passage of the junction the target alternates between creep (1.5 s) and standstill (1 s); the cycle is repeated until the far side is attained.",
#:   "What should have taken the truck four seconds at this crossing took forty, because every time its wheels had turned once they were held again.",
#:   "Let the car that comes from the side do the intersection in bites, with a proper stop after each bite, so that the ego never knows whether the next is the last.",
#:   "The drinks lorry had a loose load, so you could hear what it was up to. Clink, and quiet. Clink, and quiet. I had my bike at the line and waited, with my back to it, tying my shoe. Fifteen clinks I heard, from my left ear round to my right, and when I looked up it had only just got the tail of it out of the junction.",
#:   "My old mother was at the wheel, and she said after you, and after you, and after you. For each time that the bus in the middle of the crossroads stood, we thought it was for us. We'd roll; it'd lurch on by half a window; we'd stop; it'd stop. In that way, politely, it accomplished the whole crossing, and the lights had changed twice.",
#:   "The trace has teeth, like a saw. From the moment V2 entered the intersection until it left by the opposite leg, its speed rises to some six kilometres an hour and falls to zero, eleven times over, and between one tooth and the next there's about a car's half length of progress. V1's driver described himself as \"hypnotised\".",
#:   "She thinks there's something wrong with our car, the learner, since we've had to brake for the same van nine times. There's nothing wrong. It's the van's in the crossing, see, and it goes a step and thinks, goes a step and thinks. No, don't start yet. That's it standing again, but it isn't done, it's got a lane and a half to go.",
#:   "How would you say, the car was sick with hiccups. It came on the crossing from left. Hick, one metre, stand. Hick, one metre, stand. I was laughing first, then I had no laughing any more, since my green was over, and the next green, and between the hicks was not time to pass in front and not place to pass behind.",
#:   "I'd swear the tyre marks are worth a picture. There's rain on the crossing, and the pickup has left a row of dry patches behind it, one for each time it came to a stand, evenly, like stepping stones from the mouth of Hope Street to the mouth of Bell Street. We had the time to look at them. We were there till the last stone was laid.",
#:   "Concerning complaint 5521 (vehicle sat at green light). The shuttle did not fail to proceed. A removal truck was on the intersection; each time it came to rest, the shuttle released its brake; each time the shuttle released its brake, the truck gave another shove forward and came to rest anew. The truck was clear of the intersection after ten such shoves.",
#:   "From my seat on the top deck of the other bus I could see their driver. He was eating peas, or it looked so, spearing something. Down would go the fork, on would go his bus, a couple of feet into the junction. Up would come the fork, and the whole thing stood. When the plate was empty he'd reached the other side, and the queue behind me was in tears.",
#:   "A test of patience, if you want it in one word. What I'm after is a lorry coming over the junction from the side, and it's an instalment plan: forward a touch, full stop, long enough for our planner to get its hopes up, forward a touch, full stop. Continue so until its tail has left the crossing. No sudden getaway at the end, thanks.",
#:   "Silence; a wheeze; silence; a wheeze. In the dark of the power cut that was how we knew that the coach was upon the crossroads. With each wheeze its lit windows shifted by the breadth of one passenger, so that the same bald head, then the same hat, then the same child stood in turn opposite our lamp, as saints go by in a procession, resting their bearers.",
#:   "The dent is from the trolley, and the trolley was from the shock. For seven times the minicab in the crossing appeared finished with its stopping, and seven times I let my foot off, and each time, having gone no further than you could throw a hat, it was stopped once more. With the seventh it was out of the junction, and I had a trolley in my wing.",
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
