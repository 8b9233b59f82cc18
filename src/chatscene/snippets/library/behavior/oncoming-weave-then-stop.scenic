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
#:   "Lorry ahead tacks towards us, port, starboard, port, then lies still.",
#:   "Facing cyclist: S after S after S, then a full stop.",
#:   "From ahead, a swaying bus; at last, a standing one.",
#:   "The moped's lamp came towards my cab going tick, tock, tick, tock, like a metronome, and when the ticking ended so did the coming, as he'd pulled up.",
#:   "Opposing actor follows a sinusoidal lateral path at constant speed for the stated interval; it then brakes moderately to a standstill, still facing the ego.",
#:   "bloke coming the other way was driving like he was signing his name, big loops, kerb to line to kerb, then he just stops there and puts the wipers on",
#:   "From front side one cycle with two gas cylinders was coming, going here, going there, here, there, and at the finish both legs down, standing.",
#:   "I didn't go on until that van stood, since the whole way towards us it had used every inch of its side, over and back and over.",
#:   "Driver said to have been swatting at a bee: his coach approached in wide swings to either side before he could get it slowed and, in the end, motionless.",
#:   "Our headlights lit him by instalments. His left side, then his right side, then his left again, with a bag of bottles swinging on each handlebar, and each time he was bigger, as he was coming our way. I'd stopped by then. The last instalment was the whole of him from in front, stock-still, one foot on the road, bidding us good evening.",
#:   "Nothing in the log was violated, and still the safety driver took over, and I'd have too. The opposing pickup kept within half a metre, one metre, one and a half of its lane centre, on alternate sides, with a period of two seconds. She'd got us stationary before the fourth swing. There wasn't a fifth; the pickup's speed ran down to nought with us looking at each other.",
#:   "I was waiting on my bicycle, off the road, because the trailer on that lorry coming down towards me and the car had started to wag. Left, and the lorry with it, right, and the lorry with it. He braked it in the end, ever so gently, and we heard him put the handbrake on and be sick.",
#:   "What do you do about him, the one who's coming at us with his bonnet now at the hedge, now at the cat's eyes, now at the hedge? You slow, you keep in, you stop if need be. And you go on watching after the swinging ends, as it has now, because you want to see those wheels quite still, and there, they are, he's at rest.",
#:   "I took it for two motorcycles, one on each side of that lane, each appearing when the other went away. It was one, wagging across it as he rode to meet us; something had bent. They'd both stopped, I then saw, or rather he had, and he was sitting on it in front of our bus with his visor up, as pale as his machine.",
#:   "Vehicle 2's path on approach was reconstructed from a fluid trail. The trail crosses the center of the opposing lane seven times in one hundred and ninety feet, at regular intervals and in alternate directions. It ends in a pool two feet across, Vehicle 2 having been brought to rest there, facing Vehicle 1, which stood forty feet away with its flashers on.",
#:   "The passengers of our shuttle disagreed about the saloon on the other side. Was he dodging potholes? There are none. Was he waving? With a whole car? He'd lean it this way and lean it that way, closer with each, like a dog that's not sure of its welcome. They never did agree, and the saloon was by then standing still ahead of them with its engine off.",
#:   "One could see that something was amiss from the birds. They flew up from the left verge, then from the right one, then the left, always a bit nearer us, for the bin lorry that was coming up the lane brushed first the one and then the other. It got slower after that, and ran straight. When it wasn't going at all, they settled on it.",
#:   "Es war Glatteis, how do you say, mirror ice. In front of me the street goes up and down from there comes an autobus, and he dances. The back to left, the back to right, the front also, four times, five times, I've my hands already before the eyes. But then his tyres have found some salt, he slows and he stands, and the driver makes me a cross.",
#:   "Can I tell about the man with the wardrobe? He'd it on a bicycle. He was coming to us and Daddy, and he went whoops to this side and the wardrobe went whoops to that side, and then it was the other way round, lots of times. And Daddy stopped. And the man with the wardrobe did stop too, in the road, and held on to it.",
#:   "It would come at them out of the left half of the fog, and be lost, and come at them out of the right, and be lost; a pair of weak lamps, each time a little less weak. She had halted. She'd counted six such visits, when the lamps, on their way back once more, slowed, stayed where they were and did not get any brighter.",
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
