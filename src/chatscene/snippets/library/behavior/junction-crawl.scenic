#: description = "The car blocks multiple lanes by driving extremely slowly through the intersection."
#: rephrasings = [
#:   "A vehicle creeps over the junction and obstructs several lanes.",
#:   "The adversary inches across the crossroads far too slowly.",
#:   "The crossing car takes forever to clear the ego's way.",
#:   "At walking pace the other driver rolls through and holds up everyone.",
#:   "A long lorry crawls through the intersection.",
#:   "this thing just inches over the crossing and nobody can move",
#:   "Vehicle 2 proceeded through the intersection at very low speed, obstructing traffic.",
#:   "The bus is passing the crossing so slowly that all must wait.",
#:   "A bus was inching over the crossroads at a snail's pace and nobody could get by in any lane.",
#:   "Vehicle 2 proceeded through the intersection at approximately three miles per hour, obstructing several lanes of traffic.",
#:   "Truck crawling thru X-ing, walking pace, several lanes plugged. Never stops.",
#:   "The target traverses the junction at a constant very low speed, obstructing more than one lane.",
#:   "The car drives in the crossing so slow like a turtle, nobody can pass.",
#:   "Slow-mover in the junction box: continuous 1-2 m/s, no stops, occupies multiple lanes.",
#:   "It oozed across the crossroads like treacle, and behind it and beside it everyone had to wait.",
#:   "He's taking all day to get over that junction and he's holding everyone up, just sit tight till he's dawdled across.",
#:   "bus going like 2mph thru the intersection n nobody can get round it",
#:   "A lorry took an age to creep over the crossroads, bottling up every lane.",
#:   "Would you agree that the lorry went over the junction at barely a walk, leaving no lane free?",
#:   "That bus so slow at the junction, like tortoise, all the lanes also stuck.",
#:   "Slower than a hearse over the crossroads, he was, and spread across the lot of us.",
#:   "Multi-lane obstruction by very-low-speed intersection transit.",
#:   "SLOWEST TRUCK EVER TAKES UP WHOLE INTERSECTION",
#:   "The truck oozed over the crossroads, corking every lane.",
#:   "Tractor-trailer dawdling over the junction, three lanes shut behind his bulk.",
#:   "Cyclist trickles over the crossroads, nobody in any lane gets by.",
#:   "Crossing target: continuous creep through junction, several lanes occupied.",
#:   "Have you ever seen a bus need forty seconds for one intersection?",
#:   "Let the van dribble through the junction, never halting, hogging the lanes.",
#:   "The road train needed an eternity for those few metres, a barely moving wall of tarpaulin from one side of the crossroads to the other.",
#:   "Simulate a pickup that goes over the intersection at barely more than a standstill, always rolling, so that no lane stays free.",
#:   "An old gentleman on a bicycle pedalled so feebly through the junction that the traffic in all the lanes had to be patient with him.",
#:   "Radio to base: low loader on the crossroads, moving but only just, he's across the lot, tell the 42 it'll be late.",
#:   "Unit 2's progress over the intersection was described as glacial; it did not stop, and its length kept two through lanes and the turn lane closed.",
#:   "It goes with the velocity of a snail, this coach, over the whole carrefour, and all the tracks are closed by him.",
#:   "Forty-ton crane, see, with instructions not to go over four mile an hour on account of its load. So its driver took it over the crossroads dead steady, never stopped once, and aye, every lane was tied up while he did it, mine too.",
#:   "We waited, and it came on; we waited, and still it came on. The minibus, with its elderly passengers nodding behind the glass, drifted across the junction no faster than a man strolls, and while it drifted there was no lane one could have used.",
#:   "I put the indicator off again because there was no point. A learner was taking her hatchback through the crossroads at about the pace of a shopping trolley, rolling evenly without a pause, and what with her spread over two lanes and more, none of us had anywhere to go.",
#:   "Planner issue: the subject vehicle predicts that the crossing truck clears the conflict zone in four seconds, yet it keeps plodding through the box at roughly 1 m/s the whole way. Expected: wait behind the line, because its body covers all our lanes for twenty seconds.",
#:   "Honestly I nearly got out and pushed him. Moped, L plates, engine whining, doing maybe five kay over the intersection and smack in the middle of it, so neither lane could squeeze around. He kept moving all the time, I'll give him that, only so unbelieveably slow.",
#:   "Bus drifts through the junction at tortoise pace, lanes blocked throughout.",
#:   "Rickety bicycle barely rolling over the crossroads, everybody hemmed in.",
#:   "Target clears intersection at 0.8 m/s, steady, obstructing all through lanes.",
#:   "If the road roller's driver had got out and walked he'd have been across the intersection sooner, and the three lanes of us with him.",
#:   "I need a truck which trickles through the crossing at one metre per second from one end to the other and shuts several lanes by its length.",
#:   "Ze problem was not that the tram replacement bus has stopped, it has never stopped, it passed the crossing so slow that on all the lanes nobody could go.",
#:   "Junction of King Street, convoy with a wide boat on a pickup, creeping over now, two lanes plus turn lane unavailable, tell crews to be patient.",
#:   "One hopes the rider of that moped enjoyed the view, for he chugged through the crossroads hardly faster than the pigeons, spread right over the traffic's way.",
#:   "Overly cautious hatchback. Observed making continuous progress through the intersection, but so little of it that vehicles in three lanes were held for a full cycle.",
#:   "Our light had been green for so long that my daughter asked if it was broken. It wasn't. There was a car transporter between us and the far side, wheels turning so gently that you could read the maker's name on each tyre as it came round. It took up the lot, every lane, and it simply went on arriving.",
#:   "The coach driver told us later he'd a whole choir on board with hot soup. So that's why he was nursing it over the crossroads like a hearse. He kept rolling, I'll say that, never a halt, but at the speed he rolled he shut off two lanes on our side and one on the other.",
#:   "With thirty seconds of green at its disposal the AV moved precisely zero metres. In front of it, at right angles, a tanker was traversing the junction at a rate which the lidar initially classed as stationary. Frame by frame it did advance, however, and its long flank successively closed each of the lanes through which one might have gone.",
#:   "When I was small, circuses moved by road. You would wait at the crossing with your mother while a wagon passed, then think it had passed, and it hadn't. I was reminded of that on Tuesday, by a milk lorry. At the pace of an elephant it went over, and not a single one of the four lanes was any use to anyone meanwhile.",
#:   "The distance covered by Vehicle 2 between the two stop lines was 34 metres, and the time taken 38 seconds, with no interruption of the movement recorded. In this period neither the two lanes used by Vehicle 1 and the witness nor the adjacent turning lane could be used, and Vehicle 1 was rear-ended while waiting.",
#:   "He's got L plates, he's got a new clutch leg, and he's frightened of it, so don't you dare toot. See how the van's just ticking over, all through the box, no gas at all? It'll get there. Nobody can squeeze by him in this lane or that one, so we'll sit and have a mint.",
#:   "Video of the day: guy on a cargo bike with what looks like a sofa and a fridge. Enters the intersection at the beginning of the clip, leaves the intersection at the end of the clip, and the clip is fifty seconds. He never puts a foot down. Cars stacked up in every lane like a supermarket sale.",
#:   "Radio says there's fog at the docks and nobody's told the crane driver it has lifted. On he comes over the crossroads, one metre, then the next, smooth, no stopping, all eight axles. I can see my mate in the other lane and he can see me, and neither of us is going to work any time soon.",
#:   "Scenario parameters: approach speed of the crossing actor, normal; from a set distance before the conflict point onwards, very low and constant, with no halting permitted. Select an actor long enough, or place it such, that more than one lane of the junction is denied to the subject vehicle for as long as the passage lasts.",
#:   "My impatience was at first directed at the lights. It took me a while to see that a delivery van stood, no, did not stand, that it was moving across from the left like the hand of a clock; you looked away, looked back, and it was a foot further on, and still in the way of two queues of us.",
#:   "I am from Lyon and there also we have slow people, but this! An autocar of tourists, the chauffeur is surely searching a street name, passes the carrefour at the step of a man. Always he rolls, never he stands, always he is before all the files at the same time. Klaxons from everywhere.",
#:   "Coach oozing over the crossroads, four lanes waiting on it.",
#:   "Took that tractor-trailer a whole green to get across us.",
#:   "Bike dawdling through the box, never stopping, nobody getting by.",
#:   "We had the green, and all it showed us was the flank of an artic sliding by at the pace of a minute hand.",
#:   "could of got out, walked round the pickup and got back in again befor it had dragged itself clear of the junction",
#:   "Let the cyclist reach the crossroads normally and then pedal over it so lazily that none of the lanes can be used meanwhile.",
#:   "Not parked, not broken down, just rolling through the box at two miles an hour, with three queues of us counting its wheel nuts.",
#:   "V2 went through the intersection without halting, at roughly the speed of a pedestrian, and thereby denied the use of every approach lane to traffic.",
#:   "Do they get paid by the hour, those bus drivers who take half a minute to waft from one side of a crossroads to the other?",
#:   "Sixty-two seconds, by the dashboard clock. That's how long the side of the same furniture van was in front of me at the lights by the station. Its wheels were always going round, I'll give it that, I watched one valve cap come past, top, bottom, top. But there was no way ahead of it and none behind.",
#:   "All I expected was that it would be gone when we got there. It had been moving along quite nicely up the side road, that camper, and there's nothing to that junction. Except that as soon as it was in it, it went all dreamy, and there it still was, still in motion, still across both our lanes, when we'd come to rest.",
#:   "The planner's assumption that a crosser will vacate the conflict area in under four seconds doesn't hold for this actor. It enters the crossing at ordinary speed, drops to a slow, even creep shortly before our lanes, and keeps up the creep to the far side. No standstill, no jerking. Occupancy of the box: nineteen seconds.",
#:   "Imagine a glacier with number plates. The low-loader had nosed out from our left and it was passing in front of us, if you can call it passing, with a yard of new steel coming into view every time I looked. Behind me they were hooting. It didn't go faster and it didn't stop. It just flowed.",
#:   "In Delhi we don't have patience, you know. So when one rickshaw-type small car came in the middle of the four-road crossing and was going like a bridegroom's horse, all lanes of this side and also of that side began to shout. He was not standing, no no, he was going. Only the going could not be seen.",
#:   "I'd the engine off in the end. The funeral, I thought it must be, but there was only the one motor, a saloon, with an old chap bolt upright in it, being carried over the crossroads as if on a conveyor belt. He'd his lane and ours and the turning lane shut. And he waved to everybody.",
#:   "Sir, the claimant says that my client should have gone round. Round what? There were eleven metres of horse transporter between the one kerb and the other. It hadn't stalled. On the contrary, it was being driven over the intersection throughout, at a speed which the expert puts at three kilometres an hour, so that each of the lanes came free only in turn.",
#:   "From the saddle I've a theory: nobody minds you stopping, what makes them see red is being slow. I wobbled over the Five Ways crossing yesterday with a wardrobe on my trailer. Didn't stop once. A lane of taxis, a lane of buses and a robotaxi sat there watching me do it, at the speed of a tired tortoise.",
#:   "To test for over-eager creeping, the crossing truck is given a first section at its normal speed and, beginning just before the shared area, a second at the slow-speed parameter, which it keeps until it is out. The AV shall wait for as long as any of the lanes ahead of it is covered. It won't be short.",
#:   "You're looking for the gap behind that moped, aren't you? There'll be one. Next Tuesday. Look at it, feet dangling, chugging over the middle of the junction so slow it's nearly falling over, and in front of us and them and them as well. No, don't edge. It's on the move, that's all you can say for it.",
#:   "Residents have named it the Slug. The 6.40 works bus, they say, arrives at the cross of Mill Road and Station Road like any other vehicle and then seems to lose interest, trickling over without a pause while motorists in all four lanes look on. \"It doesn't break down. I wish it would, then you could push it.\"",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["slow"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -4.0
#: high = 26.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it comes in"
#: [[parameters]]
#: name = "OPT_SLOW_DISTANCE"
#: low = -2.0
#: high = 6.0
#: unit = "m"
#: meaning = "how far before the place where their ways meet it slows down"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 0.6
#: high = 2.2
#: unit = "m/s"
#: meaning = "how fast it crosses then"

param OPT_ADV_DISTANCE = Range(-4, 26)
param OPT_ADV_SPEED = Range(5, 9)
param OPT_SLOW_DISTANCE = Range(-2, 6)
param OPT_SLOW_SPEED = Range(0.6, 2.2)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < globalParameters.OPT_SLOW_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED)
