#: description = "The car ahead stops abruptly, waits a moment and drives off again."
#: rephrasings = [
#:   "The car in front stops dead for no reason, thinks about it and then takes off.",
#:   "Vehicle 2 made a sudden stop, remained at rest briefly and then departed at normal speed.",
#:   "Lead stops hard, short pause, pulls away.",
#:   "The target brakes to standstill, dwells, and accelerates away from the VUT.",
#:   "He is stopping suddenly in front, waits two seconds and goes away fast.",
#:   "The courier's van ahead slams to a halt, somebody looks at the map, off it goes.",
#:   "The motorbike leading us halts without notice, then zips away.",
#:   "A fire engine before us pulls up short and presently gets going again.",
#:   "The cab in front stopped dead, sat there for a sec, then toddled off again.",
#:   "The lead vehicle made a sudden stop, remained stationary briefly, and then resumed travel.",
#:   "MC ahead: abrupt halt, short wait, moves on.",
#:   "The lead vehicle brakes to standstill, holds for a short dwell time and then moves off.",
#:   "Bus before me stops quick, waits little bit and drives again.",
#:   "Lead: stop, dwell, go; once only and no reversing.",
#:   "She nearly ran into him, for he had pulled up without cause; a moment later he was on the move again.",
#:   "He's pulled up sharp, just wait behind, give him a tick, and there he's rolling again.",
#:   "car in front stopped outta nowhere for like 2 sec then kept going",
#:   "The leading bus pulled up without warning, paused and carried on with its journey.",
#:   "The car ahead ceased moving quite suddenly, tarried briefly, and thereafter continued in the same direction.",
#:   "Front scooter stopped all of a sudden, waited small time, then went ahead.",
#:   "Stops dead to read a door number, I'm standing on my brakes, and off he swans again.",
#:   "Unanticipated transient standstill of preceding vehicle, followed by renewed forward departure",
#:   "RANDOM STOP IN FRONT OF ME, then drives on as if nothing",
#:   "The van in front jolts to a halt, lingers and moves along.",
#:   "Leader halts sharply, tarries a second, sets off again.",
#:   "Van in front slams to a stand, then moves on shortly after.",
#:   "Standstill out of nowhere, tiny wait, and the coach rolls again.",
#:   "PHANTOM STOP: cab ahead freezes, then carries on like normal",
#:   "Make the motorbike before us stop hard, pause, and resume.",
#:   "The ambulance we were following pulled up so hard that its doors rattled, stood for the blink of an eye and then got under way again.",
#:   "Without any reason the truck before me brakes to zero, makes a small pause as for a photo, and then it continues its trip.",
#:   "The lead vehicle executes a hard stop in front of the VUT, remains at zero speed for the specified dwell and thereafter accelerates forward.",
#:   "i had barely come to rest behind him when he was off down the road agian and to this day idk what he slammed on for",
#:   "Driver in front missed his turning I think: anchors on, dead stop, a moment to consult the satnav, and then forward again as though nothing was wrong.",
#:   "My cousin in the pickup ahead stopped at once, quite at once, I also stopped; he was waiting a little and after that went away forward.",
#:   "The saloon was perhaps thirty yards in front when its brake lights came on and it stopped as if it had hit a wall. Nothing was in the road. It waited there for maybe two seconds, long enough for me to hoot, and then it drove on.",
#:   "Following V2 at an appropriate distance, V1 had to brake hard because V2 came to an abrupt and complete stop in the lane. V2 remained stationary only briefly, after which it picked up speed and proceeded in its original direction, its driver unaware of the near miss.",
#:   "What we're after is a one-off: the lead truck is driving along, brakes fiercely down to nothing, stands for a second or two, and then goes on its way at ordinary speed. It should not back up and it should not do it a second time.",
#:   "I ride that road every day, so I leave a gap to the buses. Good thing too, as this one stopped dead where there isn't even a stop. I unclipped, and while I was still unclipping he'd closed the case and was motoring on again.",
#:   "A cat, he thought afterwards, it must have been a cat. The car ahead had gone down on its nose and stood; he had counted two of his own heartbeats; and then it had moved off up the avenue, gaining speed, as if it regretted the fuss.",
#:   "Lead vehicle: crash halt, brief think, onward.",
#:   "Pulls up like he's hit a wall, pauses, potters on.",
#:   "Dead stop ahead of us, two-count, then gone again.",
#:   "The pickup I was behind went from thirty to nothing, sat there for as long as it takes to sneeze, and pushed on.",
#:   "Following a full stop without apparent cause, the preceding ambulance stood for a short period and proceeded along the lane as before.",
#:   "What's he stopped for? Sharp as you like he did that, and now, would you credit it, he's trundling off up the road!",
#:   "Leader to emergency-brake to zero, remain at zero for the dwell, and regain normal speed, all within its own lane and never in reverse.",
#:   "The auto in front, suddenly he is putting brake and standing, one two three, then again he is going like nothing happened to anybody.",
#:   "Because a fare hailed and then waved him away, the cabbie in front stopped with a squeal, hung on a tick, and got moving.",
#:   "I blame the ball, though it never came as far as the road. The hatchback in front of us saw it bounce on the pavement and was stationary before I'd so much as drawn breath. There we both stood. She waited to see whether a child would follow, none did, and she went on her way.",
#:   "Distance to the lead vehicle fell from 28 metres to 6 in just over two seconds. It then held at 6, both vehicles being stationary. After a short interval it began to increase again, slowly and then faster, as the lead vehicle made off in the direction it had been travelling.",
#:   "We had hardly finished picking the shopping up off the floor when the bus in front was two hundred yards on. The shopping was on the floor because the same bus had braked as if for its life and come to a stand. What it had been waiting for in those few seconds I couldn't tell you.",
#:   "Ghost brakers, my least favourite species. The motorbike ahead of me slammed it down to zero, bolt upright, boots on the floor. Nothing in the road at all. Then the boots went back on the pegs, he rolled on the throttle and away he went, and I'm left with a heart rate of one-sixty.",
#:   "So why did I tell you to leave two seconds? For this. Stop lamps, nose down, and the van's standing still, and you've pulled up with a length to spare. Don't be in a hurry to get round him, he's only had a fright; see, there's the puff of exhaust, and we're all rolling again.",
#:   "Regression 4471: the planner gives up on a vehicle which is only pausing. Repro with a lead truck that brakes abruptly to a standstill, holds position for about two seconds and resumes cruising. The correct response is to stop, wait, and follow on when it leaves.",
#:   "All at once the back of the coach was coming at him. It stopped coming when it was so near that he could read the telephone number of a firm in Bath; he read it twice through. The telephone number got smaller then, and smaller, and the coach was going on to Bath with it.",
#:   "My father, who is ninety, said there must have been a hen. The fire engine which we followed came to a standstill with a screech, and it remained so as long as one needs to say a Hail Mary. Afterwards it continued its road. We never saw the hen nor the fire.",
#:   "You could tell from the tyre marks where it had been, two black smears in the middle of an empty lane. The lorry that made them was already on the move again by the time the officer looked up, and climbing through its gears. It had stood at the end of those smears a couple of seconds at most.",
#:   "In the recording of the third party there is first a normal following drive. The leading car makes then a full braking until it stands, without any visible ground. It stands 1.8 seconds. It drives off again forwards, so the car behind, which could just hold, is left alone with its shock.",
#:   "The taxi halted, and when I say halted I mean my nose touched the windscreen. I waited for somebody to get out, but nobody got out and nobody got in. It simply had enough of standing there after a moment, and up the street it went, and we after it with the hazard lights still on.",
#:   "Lead: dead stop from nowhere, a breath's wait, onward again.",
#:   "Fire truck in front froze, thought, and carried on like nothing",
#:   "Nose down, nothing, nothing, nose up: away goes the cab ahead.",
#:   "I hit my head on the mirror, I rubbed it, and by the time I had finished rubbing the van ahead was already up the road.",
#:   "The gap to the leader collapsed to three metres, remained three metres while both of us stood, and grew again when it continued forwards.",
#:   "A pigeon, wasn't it? The bus in front went from forty to nought for a pigeon, let it finish walking, and then resumed its service.",
#:   "He is stopping full, no reason, I am stopping full, we are both sitting there like fools for two seconds, and then he is simply leaving.",
#:   "By the skid marks alone the motorcycle we followed should still be there; but it had stood only an instant at the end of them before riding on.",
#:   "Program the lorry in front so that it emergency-stops once, holds still for the length of a sneeze, and gets under way again in the same direction.",
#:   "Both my hands were still on the wheel at the horn when the horn ceased to make sense. There wasn't anybody there to hoot at. The saloon that had stood on its head in front of me, and had remained standing long enough for me to see its driver's shoulders shrug, was at the next lamp post and gaining speed.",
#:   "Three clicks of the hazard relay, that's how long we were parked on the open road behind that camper. Before the first click there'd been tyre scream, his and ours. Throughout all three he just sat. After the third his brake lamps died and he wandered off towards the coast as if he had merely been checking that they worked.",
#:   "The leading ambulance gets one fright per run and no more. It follows the road at the ego's speed; at the trigger it stands on its brakes till it's at rest; it dwells, one to three seconds; and it departs ahead at normal speed, leaving the ego to recover.",
#:   "Ask yourself what he saw that you didn't. A ball? A cat? That was as brutal a stop as I have seen this year and you did well to get down to nothing behind it. Now give him a second to get his breath back. Has he got it? He has, he's away, and so may you be.",
#:   "When the dust had settled the insured observed that there was nothing left for him to be parked behind. The van that preceded him had, without notice, been brought to a halt from fifty kilometres per hour. He'd drawn up at its doors. Within a couple of seconds, and before he could alight to remonstrate, it had been driven away up the road.",
#:   "The old tractor of my uncle did so also, but that was a sick tractor. This was a new Mercedes in front of me. In full journey it nailed itself in the asphalt. I nailed myself behind. One, two, and like woken up it drove further along the street, and I looked in my own mirror, whether I dream.",
#:   "My satnav had just said \"continue for six miles\" and so, I suppose, had his, but he'd a disagreement with his. Anchors out, full stop, his head bent over the thing. I count to two. His head goes up, his wheels go round, he continues, possibly for six miles, and my heart's in the glovebox.",
#:   "Seat belts locked throughout the bus. That was the taxi in front, which from one moment to the next wasn't travelling any more. People began to stand up to see what we had hit. We hadn't hit anything; and what they saw was only an empty street, because the taxi had used that moment to collect itself and go.",
#:   "Coroner's note: the following vehicle was not struck, nor did it strike. The lorry leading it stopped with great violence, owing, it's thought, to a swarm of bees within the cab. The window being opened, and the bees having departed after a second or two, so did the lorry, in the direction it had been going.",
#:   "The red came up like a curtain and it went down like one. During the interval nobody in our car said a thing, and nobody in theirs seemed to breathe; we were all of us at a stand in the middle of the moor with the engine ticking. With the curtain down, their car moved off along the moor as before, and ours, rather slower.",
#:   "I could tell he'd be off again, he'd left it in gear. You look for that when a truck stops stone dead in your windscreen: does it settle, or does it lean? It leaned. Two seconds he had it leaning on the clutch, looking at whatever it was on the bridge, and then it was rolling and the bridge was behind him.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["brake", "stop", "hesitate", "accelerate"]
#: position = "ahead"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -15.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.8
#: high = 3.0
#: unit = "s"
#: meaning = "how long it stands"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 6.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it drives afterwards"

param OPT_ADV_DISTANCE = Range(-15, 20)
param OPT_BRAKE = Range(0.5, 1)
param OPT_STOP_TIME = Range(0.8, 3)
param OPT_ADV_SPEED = Range(6, 10)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.05
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
