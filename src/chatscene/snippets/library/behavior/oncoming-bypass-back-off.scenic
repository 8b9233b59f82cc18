#: description = "The oncoming car stops and backs off while the ego goes around the obstacle."
#: rephrasings = [
#:   "he sees there's no room, stops and reverses out of our way",
#:   "Vehicle 2 stopped in the opposing lane and backed up while Vehicle 1 was passing an obstruction.",
#:   "opposing veh halts, reverses to make room",
#:   "The oncoming target comes to a standstill before the narrow place and moves rearwards.",
#:   "The truck stops in front of us and goes back in reverse so that we can pass.",
#:   "A bus coming the other way retreats to let us by.",
#:   "The lorry opposite pulls up and backs away from the bottleneck.",
#:   "Face to face in the narrow bit, the van gives in and rolls backwards.",
#:   "I was out round the parked lorry and the car coming at me stopped and, bless him, backed up to let me through.",
#:   "Opposing vehicle stopped and backed away as Unit 1 was passing the obstruction.",
#:   "Bus oncoming, halts, reverses, we're round the obstacle.",
#:   "While the test vehicle passes the obstruction, the opposing vehicle comes to rest and retreats rearward.",
#:   "When I go around the stopped truck, the car from the front stops and goes back.",
#:   "Opp. traffic yields during our bypass: v to 0, then negative, retreats.",
#:   "They met nose to nose beside the broken-down van, and it was the other one who stopped and shrank back.",
#:   "Go round the skip, he's seen you, he's pulled up, he's even backing off to give you room.",
#:   "i was going round the parked van and the guy coming stopped n reversed for me, king",
#:   "An oncoming driver halted and withdrew so that the other could get round the blockage.",
#:   "Seeing my client out beyond the obstruction, the opposing driver stood and then yielded ground rearwards.",
#:   "Opposite side car so nice, stop and gostan so I can go round the lorry.",
#:   "Credit where it's due, I'm out round the skip and the fella opposite pulls up and backs out of my way.",
#:   "Halt and rearward withdrawal of opposing vehicle during own passage around obstruction",
#:   "FAITH IN HUMANITY: oncoming driver BACKS UP to let me round",
#:   "The oncoming van halts and recedes while we skirt the obstruction.",
#:   "Opposing lorry sees us round the skip, halts, retreats.",
#:   "Oncoming coach: stops dead, selects reverse, gives us the gap.",
#:   "The van coming the other way stopped and went backwards for Daddy.",
#:   "Us out round the roadworks, him opposite: he stands, he reverses.",
#:   "Would the oncoming bus pull up and go backwards for you?",
#:   "While the AV squeezes around a delivery truck, let the car that comes towards it pull up and then roll back the way it came.",
#:   "The gentleman coming up the hill saw that I was already past the hole in the road, so he stopped and reversed a good bit.",
#:   "During V1's passage around the double-parked vehicle, V2 arrived from the opposite direction, ceased forward movement and then travelled backward several metres.",
#:   "I go around the broken tractor, the autobus arrives in front, he freezes one moment and then he recules to leave me the place.",
#:   "Opposing pickup's white lamps are on: he's had to stop for us passing the skip, and he's giving up the road tail-first.",
#:   "Nose to nose with a hatchback next to the fallen tree we were edging round; it stood a second and then backed down.",
#:   "You won't often have it this easy in the test. You're committed round the parked removal van, there's a Land Rover coming towards you, and look, he's brought it to a halt, checked his mirrors, and he's rolling it backwards up the lane to make you some room.",
#:   "Right on the bend there's always a bin wagon, and when I'm out past it I've no hope of tucking in. The bus that turned up opposite could've played silly beggars. Instead the driver braked, sat for half a second, then backed her up to the lay-by.",
#:   "Sequence of the opposing actor while the subject vehicle is beside the blockage: forward travel, gentle braking to zero, short dwell, rearward travel for a few seconds, final rest. The freed length shall suffice for the subject vehicle to complete its way around.",
#:   "There was a standoff, if a brief one. We were halfway round the horsebox and a milk lorry loomed up, facing us. It hissed to a stand. I could see the driver sigh, reach for the stick, and then the lorry was shrinking again, going away from us backwards.",
#:   "The comment under the clip says faith in humanity restored and I agree. Cammer is well out going round a broken-down Transit, an SUV comes the other way, could easily have bullied through, but it stops short and reverses right out of the narrow bit.",
#:   "Opposing pickup halts, then retreats while we clear the skip.",
#:   "Bus facing us stops short and shrinks backwards; we get round.",
#:   "Round the roadworks we go; the oncoming cab stands, then reverses.",
#:   "A hearse of all things came up the other way as I was passing the parked digger, and it drew to a stop and backed off with great dignity.",
#:   "The opposing lorry shall stop when the ego is next to the obstruction and shall then travel in reverse, so that the ego can finish passing it.",
#:   "He came from the front when I was turning around the broken van; he stood, he put the reverse, and he gave me back my road.",
#:   "Us beside the fallen scaffolding, a coach coming head-on: it came to a stand and its driver, bless her, reversed the thing all the way to the bend.",
#:   "You're out past the bin lorry and committed, but see, the chap in the Audi opposite has stopped and he's retiring backwards to oblige you.",
#:   "Oncoming V2, having observed V1 abreast of the stalled truck, ceased to advance and was then backed by its operator to a wider part of the roadway.",
#:   "There's a builder's skip outside number 12 that has been there since Easter. I was alongside it, well over on the wrong half, when the library bus appeared. It pulled up in front of me. I put my hands together to say sorry, he put his up to say no bother, and backed his bus as far as the pillar box.",
#:   "In Wales, where I hail from, there's an etiquette for it. Whoever's already beside the obstacle has the road. I was beside it, a fallen ash tree, and the man with the cattle lorry coming at me knew his manners. He drew to a stop, had a look over his shoulder, and it was goodbye cattle, backwards, up the hill.",
#:   "Distance to the opposing vehicle, taken from the radar: 40 m, 25 m, 14 m, then 14 m for half a second, then 17, then 22. In other words it approached, stood and receded, all of it while the automated vehicle was working its way around a double-parked van. Nobody had commanded it to do so.",
#:   "I had given up. On my left was the gas board's hole, on my right a wall, and in front a Range Rover arriving. A Range Rover never gives way, I thought. But it braked till it stood; then I saw both its white lights, and the horrid radiator which had been coming nearer began going further off.",
#:   "The child in the back of the robotaxi asked why the truck was driving the wrong way round. It was not a silly question. We were passing some scaffolding on the other half of the street; the truck had come up against us, had paused in mid-street with a hiss, and was now departing from us tail-first.",
#:   "A claim is made for the wing mirror, but not against me. I was past the middle of the broken-down bus, going round it, and the other driver, who'd been coming towards me, could have waited where he stopped. Instead he chose to reverse. He struck a lamp post going backwards, some eight metres from where he'd stood.",
#:   "Take 2 of the clip for the training course. Our car swings out round the market stall, a white van enters from the far end of the street. It slows, it's stationary, count one. The driver then selects reverse and gives up ten metres of ground. Freeze there, and ask them: would you have relied on his doing so?",
#:   "Comment below the video from user haulier_jim: that artic that came the other way deserves a medal. She's got a blind side, a trailer and a queue. Your lad's stuck out round a horsebox. So she stops, sorts her mirrors, and puts forty foot of wagon backwards round a bend just to let him by.",
#:   "Sequence for the simulator, please. Obstacle in the ego's lane, so the ego passes it on the other side. A car from the opposite direction gets near, brakes moderately and is at rest. It hesitates less than a second. It next moves in reverse for a few seconds, stops for good, and stays there until the ego's through.",
#:   "My wife says I have no luck, but I had some yesterday. I was around the half of a tractor with no wheel when a big bus is arriving from the other side. I think, now he honks. No! He puts himself still, he goes behind, behind, behind, slowly, with the warning beeper, and I can pass.",
#:   "we were sqeezed past this dumped sofa, like fully on the wrong side, and a beemer comes the other way. expected horn and abuse. instead its brakes, tiny pause, then the whine, you know the whine, and hes rolling away from us backwards giving a thumbs up. didnt know bmws did that",
#:   "us out past the skip him opposite, he halts then white lamps",
#:   "The approaching lorry thought again, stood, and rolled away rearwards for us.",
#:   "Bus coming at us gave back every metre it had taken.",
#:   "I was committed, alongside the broken-down van, and the driver facing me took one look, sat still for a breath, and gave up ground backwards.",
#:   "Have the oncoming coach come to a stand while the ego is out round the roadworks, and then travel tail first away from it.",
#:   "The headlamps that had been coming for us beside the fallen tree stopped getting bigger, and after a moment they began getting smaller.",
#:   "With V1 alongside the stationary refuse truck, V2, from the opposite direction, ceased its approach and was thereupon driven rearward, which left V1 a passage.",
#:   "Who'd have guessed that the pickup facing us would rather put itself to a standstill and creep off arse-first than make us go back?",
#:   "In front of me arrives a camion, I am beside the obstacle, there is no place for two; he stays, and then he goes from me with the back.",
#:   "You could hear its gears. First the descending whine of a lorry being brought to rest, that was when it had seen us out there beside the fallen scaffolding. Then nothing for a heartbeat. Then that high, silly whine that only reverse makes, and its great square face, which was looking us straight in the eye, dwindled down the street.",
#:   "I'd steeled myself for a row. There I was, all the way out around a skip, on a road the width of a bath, and a Volvo coming up it from the other end. It came on until we could see one another's teeth. It stopped. And then, rather than anyone's window being wound down, its reversing lights went on, and it withdrew to the pub.",
#:   "Between the hole in the road and the wall there's room for one. The one was us. What came up from the bottom of the hill was a bus, twelve metres, full. I looked at its driver, its driver's wheels weren't turning any more, and then they were turning, only the other way round, and back down the hill went the lot.",
#:   "Distance between the two front bumpers while we're passing the parked lorry, from the log: 41, 30, 21, 16, 16, 16, 19, 24, 30. Our own speed is low and constant until the 16s, then nil, then low again. So during the three readings the other was halted, and for the rest it was making off backwards.",
#:   "Children's letter to the council: We liked it when the lady in the yellow car was nice. Our bus was next to the digger and couldn't go in. The yellow car came from the front and we shouted. She stopped and put her hand on her mouth. Then she drove without turning round, all the way to the shop, so we fitted.",
#:   "The lesson isn't to bully people. You were past the middle of the obstacle, that's why it was reasonable for him to be the one who gave way. And see how: foot on the brake till the nose dips, look over his shoulder, and that whole minibus is getting shorter, well, farther off. Now give him a thank-you and get on with it.",
#:   "The expected conflict did not materialise. As the AV swung wide of a stalled dumper, an articulated lorry from the contrary direction entered the same narrow section. The AV predicted that it would barge through. It was at rest a second later, and two seconds later its speed carried a minus sign. The AV then finished its way round.",
#:   "I'm a stubborn so-and-so and don't go back for anyone. But the little robotaxi was already halfway by my broken-down mate when I came along from the other side, and it's got no face to argue with. So I put my brakes on, had a think, found reverse and took my tipper back to the gate. Everybody clapped.",
#:   "If the taxi had kept coming, I'd have lost a mirror at least, as I couldn't get out of its half before I was clear of the hedge cutter. It had ample reason to keep coming, having right of way. Kept coming it had not, though: it was stock-still, and then it had turned into a taxi going the other way, bonnet towards me.",
#:   "In Kerala lanes we've one unwritten law, who is more in, he will go first. I was fully in, next to one broken bullock cart. From opposite one SUV wala came with full pride. He put his brake, looked, I also looked. Then I heard \"tee tee tee\", his reverse tune, and the SUV became small.",
#:   "The gravel spurted the wrong way, towards us, from under the front wheels of the van. I mention it because my friend insists it was we who'd retreated. We were round the far side of a collapsed haystack and couldn't have. It was that van which, coming our way, had dug its wheels in, stood a moment, and spun them in reverse.",
#: ]
#: adversaries = ["car", "truck", "bus"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "stop", "reverse"]
#: position = "oncoming"
#: maneuver = "bypass"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 8.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 22.0
#: high = 50.0
#: unit = "m"
#: meaning = "distance to the ego at which it stops"
#: [[parameters]]
#: name = "OPT_ADV_BACK"
#: low = 1.5
#: high = 4.0
#: unit = "m/s"
#: meaning = "how fast it backs up"
#: [[parameters]]
#: name = "OPT_ADV_BACK_TIME"
#: low = 2.0
#: high = 5.0
#: unit = "s"
#: meaning = "for how long it backs up"

param OPT_ADV_SPEED = Range(4, 8)
param OPT_ADV_DISTANCE = Range(22, 50)
param OPT_ADV_BACK = Range(1.5, 4)
param OPT_ADV_BACK_TIME = Range(2, 5)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until self.pose[3] > 1.5 and gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, 0.7) until self.pose[3] < 0.05
    do Halt() for 0.4 seconds
    do ReverseStraight(globalParameters.OPT_ADV_BACK) for globalParameters.OPT_ADV_BACK_TIME seconds
    do Halt()
