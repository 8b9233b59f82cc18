#: description = "The oncoming car weaves from side to side and then stops."
#: rephrasings = [
#:   "he's wobbling about over there and then he just stops",
#:   "Vehicle 2 approached on a weaving course and came to rest.",
#:   "opposing veh, zigzag, then halt",
#:   "The oncoming target follows a sinuous path and then brakes to standstill.",
#:   "The truck goes left and right, left and right, and finally it stands.",
#:   "A tipsy cyclist wavers toward us and comes to a stop.",
#:   "The lorry opposite snakes along until it grinds to a halt.",
#:   "After slaloming a while, a biker facing us pulls up.",
#:   "the car coming the other way was wobbling left and right like he'd had a few, and then he just pulled up",
#:   "The oncoming vehicle swayed repeatedly from side to side before coming to a stop.",
#:   "Opp. bicycle: snaking, then halts.",
#:   "The oncoming target oscillates laterally and finally comes to standstill.",
#:   "The truck from front goes left-right, left-right, and at the end stands.",
#:   "Opposite actor: sinusoid in lateral offset, amplitude a lane or so, then v=0.",
#:   "The motorcyclist had come reeling towards them, now this side, now that, until he gave it up and stood still.",
#:   "Bus coming at you's all over the shop, swinging one way then the other... and now he's come to a halt, thank God.",
#:   "car coming at us was swerving all over then just stopped",
#:   "An approaching lorry veered from one side to the other before coming to a stand",
#:   "You were observed to wander left and right on your approach, and then to stop altogether?",
#:   "Opposite fellow driving like snake, left right left right, then stop there just like that",
#:   "He's coming at me all over the shop, can't hold a line, and then he just parks up",
#:   "Laterally unstable opposing traffic with final standstill",
#:   "Oncoming cyclist swerves everywhere then STOPS",
#:   "The van facing us lolled from side to side and stalled out.",
#:   "Opposing scooter meanders left, right, left, and draws to a halt.",
#:   "Oncoming pickup slaloms over its lane, then stationary.",
#:   "Car opposite, it dances right and left, at last it stays standing.",
#:   "Give me an oncoming bus that sways about and then pulls up.",
#:   "Zigzagging towards us, then not moving at all: a cyclist.",
#:   "A hatchback coming the other way drew a wavy line down the street, over and back, over and back, and ended it by stopping.",
#:   "Whoever was driving that coach towards us couldn't keep it straight; it yawed to one side and the other for seconds and eventually braked to a rest.",
#:   "The opposing vehicle's lateral position alternated about its lane centre with a period of some two seconds before the vehicle decelerated to standstill.",
#:   "My headlights picked out a motorbike coming against me with its lamp swinging like a lantern, left, right, until it hung there quite still.",
#:   "Witnesses describe an artic that approached the robotaxi in serpentines down the hill and, having done so several times, was finally brought to a stop.",
#:   "It had come to rest facing us after snaking towards us for a hundred yards, now at the kerb, now at the white line.",
#:   "He came towards us on his bicycle with a crate of beer on the handlebars, so you can imagine. The front wheel went this way and the back wheel that way, and so it went on all down the lane, till he gave up and stopped.",
#:   "Vehicle 2 was northbound, facing Vehicle 1. For approximately four seconds prior to stopping it moved alternately left and right within and beyond its lane in a repeated pattern. Its driver, who was later found to be diabetic, then applied the brake and Vehicle 2 stopped.",
#:   "In this test the facing target is made to follow a sine-shaped path of given amplitude and period. When the programmed interval is over, the lateral motion ends and the target is braked gently to zero, remaining in front of the vehicle under test on its own route.",
#:   "I can tell a sleepy trucker when I meet one, having been one. That rig ahead was coming at me like washing in the wind, drifting one way, correcting, drifting the other. I flashed him and flashed him, and at long last he stood it still.",
#:   "You know those toy cars whose wheels are bent? The car that was coming to meet our school bus drove just like one, first to us and then to the hedge and to us again. Then it wasn't driving anymore, it had stopped, and a lady got out.",
#:   "Towards us it snakes, side to side, and comes to a halt.",
#:   "Oncoming lorry, left, right, left, right, then parked up dead.",
#:   "A cyclist reels at us in wiggles, finally standing still.",
#:   "The taxi that was coming against us kept wandering, now to one gutter, now to the centre, and in the end it was brought to a standstill.",
#:   "theres a van coming the other way doing full on slalom, like no cones, and after a bit he just comes to a stop facing us",
#:   "On approach from the opposite direction the target vehicle's path shall oscillate laterally for the stated time, followed by moderate braking to rest.",
#:   "See that coach ahead, coming our way and swinging from one side to the other? Slow down, and good, he's got it stopped at last.",
#:   "From opposite the auto was coming zigzag zigzag, the driver may be sleeping, and some distance before me he put brake and stood.",
#:   "Have the motorcycle head towards the AV in a wavy line for several seconds, and then let it slow down until it stands.",
#:   "We met it on the long bit by the canal. Its headlamps went to the hedge, and to the water, and to the hedge again, like somebody saying no very slowly, and all the time they were getting bigger. I'd pulled up already when they steadied and stayed the same size, for the lorry had pulled up too.",
#:   "The pen trace shows it best. From the moment the opposing car appears its lateral position writes a regular wave, about a metre to either side, five crests in all. After the fifth the wave goes flat, and so, some two seconds later, does the speed, at zero.",
#:   "He's a diabetic, poor lad, it came out afterwards. All I saw from the pavement was a pickup that couldn't decide which side it wanted as it came towards the blue car, first this side, then that side, then this. It ran out of go in the end, or he'd braked, and it stood there with the engine ticking over.",
#:   "Claimant's narrative: the third-party bus was approaching from the front. Its course was erratic, alternating between the nearside and the offside of its lane several times. I stopped as a precaution; the bus, too, was eventually halted, some way ahead of me, and I learned that the driver had been stung by a wasp in the cab.",
#:   "I've been on bikes all my life and I know a tank-slapper when one's coming at me. Bars flapping, lock to lock, the whole machine going left and right and left down the oncoming side. He caught it, bless him, he got it slower and slower, and when it didn't move any more he simply sat there on it and shook.",
#:   "Vehicle 2, approaching from the opposite direction, was seen by three independent witnesses to deviate repeatedly to both sides of its line. No contact was made with any other road user. Vehicle 2 thereafter decelerated and was stationary, facing Vehicle 1, when the first officer arrived.",
#:   "It was like watching somebody try to thread a needle in a gale. The artic was on its way down to us, and its trailer would go out to the left, and its cab to the right, and then the other way about. Nobody spoke in our car until the brakes had bitten for good, and the monster stood there in front of us, hissing.",
#:   "On the ice in Zhangjiakou it is normal thing. One oncoming bicycle, he cannot keep direct, the wheel goes east, the wheel goes west, many times, so I drive very small speed. At last he doesn't ride any more, he uses brake and he stands with two shoes on the ice.",
#:   "I was doing the accounts in the back of a robotaxi when it slowed for nothing that I could make out. Then I looked ahead. A camper coming from the other direction was rolling from edge to edge like a drunk in a corridor, over and over; by and by it wasn't rolling, it wasn't doing anything, it had come to rest.",
#:   "My brother can do this with his toy bus on the carpet, swish to one side, swish to the other, and he makes the noise. The real bus that was coming to our car did that too, without the noise. Then it got tired and slower and it stood, and the driver came out and he had soup on his shirt.",
#:   "Which of its tyre marks belong to the drink and which to the brakes? The first forty metres, those that swing to and fro like a river on a map as they come towards where the ambulance was waiting, belong to the drink. The straight ones at the end, under the wheels, belong to the brakes, for there the hatchback stopped.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "weave", "stop"]
#: place = "road"
#: position = "oncoming"
#: maneuver = "straight"
#: leader = false
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 8.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 1.3
#: high = 2.2
#: unit = "m"
#: meaning = "how far it swings"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 2.5
#: high = 3.5
#: unit = "s"
#: meaning = "how long a full swing takes"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 4.0
#: high = 6.0
#: unit = "s"
#: meaning = "how long it weaves before it stops"

param OPT_ADV_SPEED = Range(5, 8)
param OPT_ADV_AMPLITUDE = Range(1.3, 2.2)
param OPT_ADV_PERIOD = Range(2.5, 3.5)
param OPT_STOP_TIME = Range(4, 6)

behavior AdvBehavior():
    do WeaveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD) for globalParameters.OPT_STOP_TIME seconds
    do BrakeOnPath(advTrajectory, 0.7, 1.5)
