#: description = "The parked car pulls out and drives straight across the road to the other side."
#: rephrasings = [
#:   "The parked car cuts straight over the whole street in front of us.",
#:   "Vehicle 2 departed the curb and traversed the roadway toward the opposite side.",
#:   "Parked veh crosses carriageway to far side.",
#:   "The target starts from the roadside and crosses the VUT's path transversely.",
#:   "It goes from the parking to the other side, directly across.",
#:   "A van sets off from the side and heads into the yard opposite.",
#:   "The motorbike scoots from its parking spot right over to the far pavement.",
#:   "The lorry at the roadside lumbers over both lanes to a gate across the way.",
#:   "a parked motor shot off his spot and went clean over the road to the far side in front of me",
#:   "V2 left its parking space at the curb and drove directly across both lanes to the opposite side of the street.",
#:   "Van parked RHS: moves off, straight over rd to other side.",
#:   "A parked target leaves the kerbside and traverses the full carriageway to the opposite edge, crossing the VUT's path.",
#:   "The car stands on the side, then it starts and goes across the whole street to the other side.",
#:   "Parked actor leaves its bay and cuts over the full road width, doesn't join our lane, just passes over it.",
#:   "The motorbike had been propped at the roadside; now it set off and made a beeline for the shops over the way, right before them.",
#:   "That police car's leaving the kerb, and he isn't joining the traffic, he's heading for the far side of the road, right across you.",
#:   "parked car just went all the way across the street right in front of us to the other side",
#:   "A van that had been standing at the roadside bolted over the entire width of the High Street before startled traffic",
#:   "You left the kerb and did not stay in the lane but carried on clean over to the opposite pavement?",
#:   "The parked scooter started and went this side to that side fully, cutting our way",
#:   "Parked up nice as pie, then he's off to the kebab shop opposite, straight over my bonnet",
#:   "Full-width transverse crossing by vehicle departing from parked position",
#:   "Parked pickup drives STRAIGHT ACROSS the street in front of me",
#:   "The police car sliced from its bay to the far kerb.",
#:   "Pickup off its parking bay, clean over both lanes, far kerb.",
#:   "Lorry leaves roadside and bisects the street, making for the opposite yard.",
#:   "Have a parked scooter start up and slice over to the far side.",
#:   "She was parked, no? Then she traverses all the street till the opposite trottoir.",
#:   "From this kerb to that one, straight over: the police car's strange departure",
#:   "With no interest in joining our lane, the estate parked up ahead came out and headed square over the road for the car wash opposite.",
#:   "The ambulance abandoned its spot by the pavement and lumbered over the full width of the street, ending up outside the surgery on the other side.",
#:   "A hatchback that had been sitting at the kerb shot through the ego's path at right angles and was only done when it reached the gateway facing.",
#:   "Having unloaded on one side, the drayman evidently wanted the cellar on the other, so he fired up his truck and drove it squarely over in front of us.",
#:   "Will that motorbike by the lamp post follow the road when it moves off? No: there he goes, directly over, to the shops on the other side.",
#:   "Start state: target stationary in kerbside bay. On trigger it moves out, steers about ninety degrees left and clears the whole carriageway to the far edge.",
#:   "We cyclists get used to cars nosing out of bays, but they normally then drive along. This one didn't. The bloke started up, cranked the wheel hard over and went plain across the road, both directions of it, till he was at the garage doors on the opposite pavement.",
#:   "My lorry was the third vehicle to have to brake. The fella in the parked Transit had obviously spotted a space on the far side that he fancied, because he swung off the kerb and went over the lot of us, crossways, to bag it, and never mind who was coming.",
#:   "Question from a parish newsletter reader: is it legal to set off from a parking place and proceed directly over the road? Only on Sunday a people carrier did precisely that before my very bonnet, leaving our kerb and coming to rest by the church wall opposite.",
#:   "The fire engine had stood against the pavement for an hour, its crew at their sandwiches. Now the bell went; out from the kerb it rolled, and athwart the whole of the road, for the burning house was right over the way, and the traffic on either hand had to let it by.",
#:   "For this scene I need a car at rest by the side of the road. As the AV comes near, it should get going and run transversely over our lane and the next one until it arrives at the other edge; it neither turns back nor merges with us.",
#:   "Taxi off the rank, square over the street, far pavement.",
#:   "Kerb to kerb, sideways on: parked Jeep bisects the traffic.",
#:   "ambulance left its bay n drove over the whole road to the other side",
#:   "Two tyre tracks in the fresh snow ran from the empty parking space at our kerb, at a right angle over both lanes, to the barn door opposite.",
#:   "Parked on the right, the motorcyclist wanted the café on the left, and so he set off and took the shortest line, through our path and beyond.",
#:   "Let the tow truck wake up at the roadside, come out, and keep on going broadside over the street until it's in the forecourt facing its old place.",
#:   "I expected that van, when it left its parking place, to go our way, but it had no use for our way and only wanted the driveway opposite.",
#:   "V2 departed a parallel parking stall, was steered hard to the left and cleared eastbound and westbound lanes in one movement, ending on the opposite shoulder.",
#:   "Would a sensible man quit the kerb and drive over the entire width of a busy road to the alley on its other side, with a lorry coming?",
#:   "The florist had parked outside our house to tie her ribbons. She finished, she climbed in, and I was just past the letter box when her estate car came out and presented me with its whole side. Roses, lilies, roses. It didn't follow the street, it went over it, and the next I saw it was under the chapel arch opposite.",
#:   "Somebody had left a pickup at the side with its engine off, so the AV had it down as furniture. Then the furniture got up. It was across our lane before the label changed, across the other lane by the time we'd slowed, and by the time we'd stopped it was in the field gateway on the far side.",
#:   "Constable, it was a matter of hay. The fellow's lorry had stood on this side of the road all morning, and the hay was in the barn on the other. At noon he moved off from the verge, turned its nose square to us and drove directly over to that barn, and me with a trailer of sheep and no brakes to speak of.",
#:   "It was a beautiful demonstration of what I always say: a parked car's got a driver until you've proved otherwise. Those wheels were cranked full left. Out it came, and did it join you? No. It sailed through your lane, it sailed through his, and look, it's tucked up against the pavement over there.",
#:   "The first thing that was wrong was the angle. Cars that come off the kerb come off it slantwise and straighten up, but this one's bonnet kept on swinging until it pointed at the greengrocer's over the way. And to the greengrocer's it went, while the lot of us, both directions, stood on our brakes for him.",
#:   "At the time of the incident the fire engine had been positioned at the nearside kerb for refuelling of its pump. On receiving the call, the crew took it out from there and over the full breadth of the highway to the yard entrance opposite. Vehicle 1 braked; the distance remaining was under three metres.",
#:   "In our village one parks where there is shadow. So the little Renault has been at my side of the road since lunch, and when the shadow changes, the owner changes also. He starts, he makes a quarter of a turn, he traverses everything, me included nearly, and there he is under the trees of the other pavement.",
#:   "There's a bug where the tracker joins the parked vehicle's path to our lane by default. Counterexample attached. Here the motorbike leaves its slot at the edge, yaws by about ninety degrees and exits on the opposite edge of the road. It's in our lane for 1.1 seconds, purely in transit, and never travels along it.",
#:   "Bert's leg was bad, so he wouldn't walk over to the Red Lion. He'd drive. I was behind the wheel of the number 9 and I watched him: unlocks it, gets in, pulls off the kerb with never a look, and trundles straight over the High Street, kerb to kerb, to the pub car park. Twenty-two feet, it is.",
#:   "Nobody in the queue outside the cinema will forget the police car. It had been sitting at the pavement beside them, lights off. With no warning it pulled away, shot at right angles through the traffic on one side and then the traffic on the other, and mounted the kerb by the bank facing us.",
#:   "I'd got my bicycle half up on the pavement, thank God. This black cab, which had been waiting there with its hazards on, moved away from the edge and simply carried on going left until it had run out of road. The bloke in the Audi, who'd been about to pass it, missed its back door by a gnat's.",
#:   "Parked truck upped and made a beeline for the opposite pavement.",
#:   "Van from our kerb, square over all lanes, into the yard opposite.",
#:   "parked bike next to me just went. straight over. other side. no signal",
#:   "There was an empty space at our kerb where the taxi had stood, a taxi in the drive straight opposite, and, in the middle of the road between them, my screeching front tyres.",
#:   "It wasn't joining the traffic, the police van that came off the kerb; it cut the road at right angles and was done with it on the far side.",
#:   "Wanting the petrol pumps over the way, the driver of the parked saloon took them by the shortest route, that is to say through us, crossways.",
#:   "The adversary shall rest at the kerb with its engine running; when triggered, it shall leave, assume a heading perpendicular to the road and clear the opposite edge.",
#:   "My pupil expected the lorry to move off in our direction like any honest parked vehicle, and so was facing the wrong way when it presented its flank and rumbled off across to the other side.",
#:   "From a standstill by the pavement into the alley opposite, without a metre being driven along the street: that's how the motorcycle went, and that's why V1 braked.",
#:   "I deliver bread, so I know who's parked where. The blue Transit lives outside number 12. On Tuesday it wasn't outside number 12, it was broadside to my windscreen, and I had tiger loaves on my shoulders. A moment later it was in the drive of number 15, which is directly opposite, and its driver was getting out with his keys as if he'd walked.",
#:   "Two doors slammed, that's what I remember, and then the whole parked car came away from the pavement and I thought, right, he'll pull in front and I'll follow him to the lights. I'd even begun to lift. But what I was looking at was his side. He was off over both lanes to the cinema car park and he'd not wasted a wheel turn on going our way.",
#:   "In the photograph you see a fire engine that isn't attending anything. It stood at our kerb, in front of the baker. The station is across the street from the baker. Somebody pressed the button for the doors over there, and it went home: off the kerb, one turn of the wheel, straight over. If I hadn't braked we would've gone in with it.",
#:   "Parked vehicles are treated as static until they've moved half a metre, and by then this one had turned its face to the other side of the road. Log 19: HGV at kerb, wheels hard over; t plus one, HGV athwart our lane; t plus three, HGV athwart the opposing lane; t plus five, kerb vacant and HGV in the depot gate opposite. Please shorten the delay.",
#:   "As a child I believed that cars slept at the kerb. The grey one opposite the church can't have been. We were almost level with it, Father and I, when it came out and showed us both its left wheels, and it did not turn to go with us or against us. It simply went from our pavement to the church's, as one goes from bed to window.",
#:   "The ball joints are gone because I used the central reservation, and I used the central reservation because a biker who'd been sitting on his machine at the side of the road kicked it off its stand and took the road the short way. Short way, I mean left to right, kerb to kerb, straight over. I went behind him. There was no in front.",
#:   "\"Did it indicate?\" \"It did, as though to join the lane.\" \"And did it join the lane?\" \"No, madam. The lane was where I was. It came off the kerb and at once I had it lengthways across my view, from one headlamp to the other. It continued in that direction until it ran up the dropped kerb on the far side.\" \"And you?\" \"I was by then on the horn.\"",
#:   "So there I am cycling past the row of parked ones, watching for doors like they tell you. No door opens. What opens is a gap, because the third one in the row has left it, and it's left it sideways. It went over in front of the AV and me, over the cycle lane on the other side, and into somebody's front garden path.",
#:   "Bitte, this was not a turn to go back. Turning back I know, one makes a circle. The ambulance that stood at the border of the street made no circle, it made a corner: out, then nose to the other houses, then over all and in the entrance of the clinic. My tyres have made also something, a black line of eleven metre.",
#:   "Nobody could say the old gentleman wasn't careful. He looked in his mirror, he looked again, he let a leaf blow past. Then, since all he wanted was the other side, he brought the Rover out from its place and pointed it at the other side, and drove to it. That the other side lay beyond us was something we had to deal with ourselves, in about nine feet.",
#:   "Simulate the \"depot opposite\" case. A box truck is waiting at the nearside kerb, facing with us. As the ego comes up it pulls away, but instead of following the lane it yaws to nearly ninety degrees, obstructs us with its whole length in passing, and leaves the roadway on the other side. It doesn't come round to face us, and it must not get stuck half-way.",
#: ]
#: adversaries = ["car", "truck", "motorcycle", "emergency-vehicle"]
#: requires = ["advKerb", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "pull-out", "turn-left"]
#: side = "right"
#: position = "kerb"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 8.0
#: high = 24.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.5
#: high = 4.5
#: unit = "m/s"
#: meaning = "how fast it crosses"

param OPT_ADV_DISTANCE = Range(8, 24)
param OPT_ADV_SPEED = Range(2.5, 4.5)

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3) for 0.3 seconds
    do TurnOff(1.2, globalParameters.OPT_ADV_SPEED)
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for 5 seconds
    do Halt()
