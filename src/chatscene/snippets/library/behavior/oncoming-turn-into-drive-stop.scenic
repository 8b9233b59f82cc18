#: description = "The oncoming car turns left across the ego's lane and stops broadside."
#: rephrasings = [
#:   "he swings across for the driveway, can't get in, and stops bang across our lane",
#:   "Vehicle 2, oncoming, began a left turn into a driveway and came to rest across the lane of Vehicle 1.",
#:   "opposing veh turns left, stands broadside in our lane",
#:   "The oncoming target turns left off the carriageway and comes to a standstill across the path of the VUT.",
#:   "The truck wants to enter the yard at the left but it stops on our lane, crosswise.",
#:   "The gate is shut, so the lorry turning in from the opposite side blocks us.",
#:   "A biker facing us hooks left over the lane and halts side-on.",
#:   "A van coming the other way bends left toward the car park and waits, sideways in our path.",
#:   "he came the other way, turned over my side for a driveway and stopped side-on in front of me",
#:   "The oncoming vehicle turned left across V1's lane and stopped perpendicular, blocking it.",
#:   "Opp. truck: L over our lane, halts broadside.",
#:   "The oncoming target turns left into a property access and comes to rest transversely in the VUT's lane.",
#:   "The bus from front turns to the left side and stays cross in my lane, like a wall.",
#:   "Opposite NPC left turn towards an entrance, v=0 midway, full side profile towards SUT.",
#:   "The car had wheeled left towards a gateway and then pulled up with its whole flank turned to them.",
#:   "He's coming over for that driveway on your side and... he's parked himself sideways over your lane. Gate must be shut.",
#:   "he was coming at us, turned left over our lane, and stopped completely sideways",
#:   "A van turning left out of the opposing flow came to rest side-on, walling off the lane",
#:   "You turned left over my client's lane and there stood still, presenting your flank to her?",
#:   "Opposite lorry taking left across us and then stopped in horizontal, full side showing",
#:   "He swings left over me from the other way and then parks it longways across my road, I'm looking at his door handles",
#:   "Left turn of opposing traffic over own lane, transverse standstill",
#:   "Oncoming truck turns left and stops SIDEWAYS in my lane",
#:   "The bus facing us swung left and lay across our lane.",
#:   "Coach facing us swings left for a gateway, ends up parked across us.",
#:   "Lane closed: opposing van turned left into it and sits crossways.",
#:   "Please let the oncoming truck bend left over our lane and halt lengthwise.",
#:   "Side-on and motionless: the motorbike that had turned left before us.",
#:   "From ahead, left over our lane towards a yard, dead stop, full flank.",
#:   "A skip lorry approaching from the far end made a left over the lane of our car, meaning to enter a farm track, and came to a standstill with its flank towards us.",
#:   "There was a dog lying in the driveway, so the oncoming estate, which had started its left turn over my side, stayed put with its doors facing my grille.",
#:   "The opposing vehicle leaves its lane by a left turn towards an access road and, when perpendicular to the VUT's lane, is brought to a stop and kept there.",
#:   "V2 had been eastbound; it turned left across the westbound lane towards a car wash entrance and was at rest, its right side exposed to V1, at impact.",
#:   "I want the bus from the opposite direction to turn to its left across us for some driveway but only get halfway and stand there like a barrier.",
#:   "Tempo came from opposite, took left through my lane for one godown, gate was not open, so he is just standing crosswise and road is jammed.",
#:   "I could see he wanted the pub car park on my side, and fair enough, there was time for him to get in. But having come round to the left he stopped with his front wheels on the pavement and the remainder of that horsebox lying right across my lane.",
#:   "Forty-footer, reporting. I was coming up the hill, took my left for the quarry entrance and some genius had left the chain up. So I had to stop where I was, sideways over the downhill lane, and that electric thing without a driver was headed for my fuel tank.",
#:   "Think of a door being shut in your face. The taxi had been approaching us on its own side; it swept left, over our lane, towards the entry of the hospital, and there it halted, and from one edge of the lane to the other we saw nothing but yellow paint.",
#:   "Test idea for blocked-path handling: an SUV approaches from the front, makes its left turn in the middle of the block to reach a private access, and instead of finishing the move it stops at ninety degrees to our heading and remains a wall.",
#:   "Madam, it is right that the motorcycle was coming in the opposite direction, and that it turned left over the lane you were using, in the direction of a garage? And it was not moving any longer, but standing there side on, when you first braked?",
#:   "Bus from ahead bears left over our lane, halts crosswise.",
#:   "Facing truck: left across us, then motionless, flank on.",
#:   "Make the oncoming moped swing left before us and stand side-on.",
#:   "The horsebox that had been coming our way took its left towards the riding school and then stood, tail still over our lane, because the gate was shut.",
#:   "The opposing target executes a left turn off the carriageway and is brought to rest when its body lies transversely on the path of the VUT.",
#:   "Opposite tanker is cutting left through my lane for the petrol pump, there is queue, so he has stopped crosswise and I am looking at his belly.",
#:   "She drives towards me, she makes the left around over my half for the bakery, and there she remains standing like a gate which is closed.",
#:   "V2, which was southbound, had begun a left turn toward a private lot and was stationary at ninety degrees to the northbound lane when V1 came upon it.",
#:   "Let an SUV that meets us turn to its left in front of the AV, heading for a garage, and park its whole side in our way.",
#:   "I could read the phone number of the firm, and the name of the firm, and its motto. That's how long I had and that's how square it stood to me. The van had been coming from the other end of the street, had turned left in front of me to get to number 30, and had got no further than my lane.",
#:   "On the tape there's a beep-beep-beep, but that's not him reversing, that is my parking sensor. He'd come from the front, you see, he had made his left for the driveway and found a toddler's bike in it. So he stood where he was, his two doors where my lane ought to be, engine ticking over.",
#:   "Please note that we were by no means speeding. A bus approached from the opposite direction, signalled to its left and passed over our lane in the direction of the coach park, where there was evidently no space; its rear two thirds thereupon stayed at a standstill across our lane, and we could go nowhere.",
#:   "Down came the barrier, as one might say, but it was a bike. The man on it had been riding towards us with his girl behind him. He leaned left, over the line, over our lane, in the direction of the campsite, and then she must have said something, because there he stopped, broadside, and turned his head to argue.",
#:   "Now a lot of people think the danger is over when he has begun his turn. It isn't. That pickup was coming towards us, it has gone left over your lane for the builder's merchant, and what's he done? He's pulled up. You've got eighteen feet of pickup, sideways, and nothing's moving, so stop.",
#:   "Location 14.2 km, two-lane road, farm access on our side. The opponent vehicle turns left out of its lane with 5 m/s at 20 m range. Expected by our predictor: it clears in 2 s. Observed: after crossing the line it comes to zero speed perpendicular to us, and remains so, full length across the lane.",
#:   "We had the right of way and we had it carved in stone, as my late father would say. It did not move the lorry. The lorry had approached us, swept left over our lane with its nose for the quarry gate, and come to a stop with its loaded body lying athwart the road from line to hedge.",
#:   "A wall can appear very quickly when it is on wheels. There had been a coach a hundred yards ahead, coming on in its own lane as it should. There was now, in ours, a long cream-coloured side with fourteen windows, not stirring, for the coach had wheeled to its left for the hotel and found the forecourt full.",
#:   "Grey Golf, facing. Over left in front of Unit 1 for the nail salon. Stopped short of pavement for a lady and pram, so its whole side blocked Unit 1's lane. Unit 1 hit rear door at about 20. Golf was standing at the time, driver of Golf agrees to this.",
#:   "My grandson built it on the carpet for the insurance man. Here's us, he said. Here's the yellow truck coming to meet us. And it turns to its left, like this, right over where we want to go, and then it doesn't go in the yard, it stops, see, and it's lying like a log in front of us.",
#:   "We need a blocked-lane variant born from a left turn. An oncoming taxi crosses the ego's lane as if going into an entrance on the ego's side, but with its body at about a right angle to the lane it halts for good. There must not be any room in front of or behind it.",
#:   "Approaching van hooks left, dies broadside, and our lane has a wall.",
#:   "Make the facing taxi bend left before us and stand crosswise.",
#:   "One left turn from ahead, one closed gate, one blocked lane.",
#:   "I was looking into the eyes of thirty schoolchildren, a window each, for their bus had come from ahead, gone left over our lane and stuck there side-on.",
#:   "The pickup opposite made its left for the timber yard and got as far as lying flat across our half, where its wheels stopped turning.",
#:   "What had been an oncoming headlamp was now a tank, a seat and a number plate in profile, unmoving across my lane: he'd hooked left for the pub.",
#:   "The opposing target is to yaw left through ninety degrees over the VUT's lane, and to be braked to rest there, flank exposed, until the end.",
#:   "The lorry coming down to meet you wants that yard on your side; he's come left over your lane, there's no room in it, so he's standing.",
#:   "His garage door, which ought to have been opening, wasn't, so the whole oncoming Mercedes, midway through a left over our lane, waited for it there.",
#:   "The insurer has asked where on the other vehicle I hit it. In the exact middle, I'm afraid, between the two doors. It'd been coming to meet me a moment before, front first like anybody. It turned to its own left, over to my side for the vet's, where a horse was being led out, and lay still.",
#:   "For two reasons our robotaxi could not go on. The first had a cab, the second a trailer, and they were hitched together. They'd approached on the far lane and swung left, over ours, for the boatyard; the cab was in the gateway, where a man held up his hand, so the trailer was at rest in front of us from edge to edge.",
#:   "I'm five foot one, I couldn't see over it. All I know is that the road had been open, with a minibus on it, at a distance, coming. Then my view was a handle, a sliding door, a sill. Through its windows I saw the nursing home it had turned left for. It just stayed put, so I stayed as well.",
#:   "Whoever draws the next training poster can have this. A driver's facing us and signalling left. He has time to get in, we've time to let him. He's over our lane, his nose is on the pavement, and there's a wheelie bin. So there's no more \"in\" to be got. Flank to us, brake lights on, two tons across the way.",
#:   "The black box gives V2's heading as 182 degrees, V1's being 2. At 16:20:07 V2 began a left turn, passed the centreline, and at 16:20:09 its heading was 94 and its speed zero. Both values then remain. The point is in V1's lane opposite the car park entrance, whose barrier did not lift.",
#:   "It wasn't the motorcyclist's fault that the lady came out with her pushchair. He had been riding towards us, he had leaned to his left, gone over the line, gone into our lane on the way to the hotel steps. Well, he couldn't very well run her down. So he stood on his two feet, lengthwise over the lane, and we slid.",
#:   "Like a drawer pulled out of a chest, that's how the coach came out of the opposing lane, leftwards, into ours. The chest analogy breaks down there, the driver said with a laugh, for nobody pushed it in. The bus park was full. Fifty feet of coach lay square across the road, and we ate our sandwiches before its luggage hatches.",
#:   "From the audio notes. Oncoming grey SUV, okay. Blinker, his left. He's crossing us, should clear in about two. One, two. He isn't clearing. Heading's perpendicular, speed's zero, he's all of lane one. Driveway's occupied by a skip. Still zero. I'm taking over, we're stopped four metres off his back door.",
#:   "I was hanging out the washing, so I had the whole road. The blue one was going up. The cement mixer was coming down, and it wanted in at number 8, on the blue one's side. It got itself round, left hand down, till it was square over that lane, and it conked, or he did. The drum went round, the wheels didn't.",
#:   "The scene that I have before me since, when I close the eyes: a camion comes from in front, he makes his left to go in the vineyard, before my nose, good, I lift the foot. But the vineyard has a chain. And so it rests there, this long side with the barrels, from the one ditch to the other.",
#:   "He'd have been hard put to choose a worse place to stop. Coming the other way, he'd taken his left across our lane, and one yard sooner he would've been in his own, three yards later he'd have been in the forecourt. Between them he heard his phone, pulled on the brake, and showed us the full length of his Transit.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "turn-left", "stop"]
#: position = "oncoming"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 6.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 18.0
#: high = 45.0
#: unit = "m"
#: meaning = "distance to the ego at which it turns"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.0
#: high = 0.5
#: unit = "s"
#: meaning = "how long it goes on before it stops across the lane"

param OPT_ADV_SPEED = Range(4, 6)
param OPT_ADV_DISTANCE = Range(18, 45)
param OPT_STOP_TIME = Range(0, 0.5)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do TurnOff(1.1, globalParameters.OPT_ADV_SPEED, 5)
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for globalParameters.OPT_STOP_TIME seconds
    do Halt()
