#: description = "The parked car pulls out, stops and backs up toward the ego."
#: rephrasings = [
#:   "He pulls out, stops, and then comes back at us in reverse.",
#:   "Vehicle 2 left the curb, stopped in the lane and backed up.",
#:   "Parked veh out, stop, reversing in lane.",
#:   "The target merges ahead of the VUT, stands and then moves rearward.",
#:   "It comes out of parking, stands before us and goes backward.",
#:   "A removal lorry leaves the side, halts and backs to line up with a door.",
#:   "The taxi sets off, sees a hand go up and shunts back.",
#:   "Out of his space, the driver notes he forgot his wife and reverses.",
#:   "This parked van came out, halted, then started backing at me, beep beep beep.",
#:   "Unit 2 left its parked position, came to a stop in the travel lane, then backed toward Unit 1.",
#:   "Truck out of bay, halt, then R gear towards us.",
#:   "The parked target enters the lane, comes to rest and then moves rearward in the direction of the test vehicle.",
#:   "Car goes out from parking, stands, and comes backwards to me.",
#:   "Parked actor: leaves the edge, stops in our lane, then negative speed into our approach.",
#:   "It had come out from the roadside and paused, and then its white lamps lit and it rolled backwards at them.",
#:   "Bus is moving off from the side, he's stopped, watch it, he's in reverse and he's coming at you.",
#:   "parked truck pulls out, stops, then starts coming at me BACKWARDS",
#:   "A delivery van moved off from the roadside, halted and then rolled rearwards at an approaching driver.",
#:   "Having come out from the side and stood, your vehicle then travelled tail foremost upon my client, correct?",
#:   "The parked lorry come out, stop, then gostan towards my car, siao or what.",
#:   "Comes off the side, has a sit, and then he's backing down on me with his rear end getting bigger and bigger.",
#:   "Departure of parked vehicle into own lane, halt and subsequent rearward approach",
#:   "PULLS OUT, STOPS, THEN REVERSES AT ME",
#:   "The parked bus emerges, halts and backs down upon us.",
#:   "emerges from his parking place halts and rolls back toward us",
#:   "Bus leaves kerb, stands, then comes at us tail first.",
#:   "Parked van: out into lane, stop, reverse lamps, approaching.",
#:   "MY BONNET vs HIS TOWBAR: parker drives out, stops, backs at me",
#:   "Make the parked ambulance enter our lane, stop and reverse.",
#:   "The dustcart drew away from the pavement into my lane, pulled up, and the next thing I knew its beeper was going and it was getting nearer.",
#:   "From a kerbside position the target vehicle enters the lane of the VUT, comes to a standstill and, after a short pause, travels backwards toward it.",
#:   "He'd forgotten something, I suppose: out of the space he came, stood on the brake in front of us and started reversing our way.",
#:   "The parked taxi is coming out, it stands in my lane, and then suddenly it drives retro in my direction, what is very dangerous.",
#:   "First it was at the side of the road, then it was in front of us not moving, and then its white lights came on and it backed.",
#:   "Did the lorry which had just left the kerb and halted in your lane then proceed in reverse towards the front of your vehicle? It did.",
#:   "I was passing a line of parked cars when a people carrier came out of a bay in front of me and stopped after a few yards. I stopped too. Then the reversing lights lit up and she came backwards at me, looking only at her phone.",
#:   "Vehicle 2 was parked at the right-hand kerb. It pulled into the lane ahead of Vehicle 1, braked to a halt and, some half a second later, moved in reverse for several seconds in the direction of Vehicle 1, whose driver was sounding the horn.",
#:   "Scenario idea from the depot: a removal truck sits at the side, moves off right into our lane, comes to a stand, and then its driver decides he was better off where he'd been and shoves it in reverse, straight down on the AV behind.",
#:   "We had a good laugh about it on the show, but at the time it wasn't funny. This police car leaves its spot by the pavement, gets in our lane, stops, we think fine, he's waiting. No. He goes into reverse and his boot comes looming up at us.",
#:   "Keep your eye on parked vehicles with somebody at the wheel. That minibus has joined the road in front of you, and it's pulled up again; leave plenty of room, for see, it's coming backwards now and the driver hasn't a clue you're here.",
#:   "Slipped its berth, pulled up in our lane, then came astern.",
#:   "Parked bin lorry emerges, halts; reversing bleeper, tail approaching us.",
#:   "From roadside into our lane, full stop, and then rearward towards us.",
#:   "I'd only just stopped behind the minibus, which had drawn out of its bay and pulled up, when the thing started coming at me arse-first.",
#:   "Does anyone look behind them any more? Out from the kerb, stop in my lane, and then the cab's backing up at my grille!",
#:   "Kerbside actor departs, occupies the ego lane, reaches standstill, dwells briefly, and then translates rearwards so that the longitudinal gap to the ego shrinks.",
#:   "The ambulance was in the parking, it came in my lane and stood, after half second it was coming to me with the back side.",
#:   "Have the parked courier van set off into our lane, pull up a few yards on and then, in reverse, roll down on us.",
#:   "First missing thing was a parcel, so the postman, who had just left the kerb and halted before us, drove it backwards our way.",
#:   "I have given my evidence three times now. The cattle truck was at the roadside outside the Bull and left it as I drew near. It stopped in front of me, which I could live with. What I couldn't live with was the tailboard getting larger, and it was getting larger because he was backing.",
#:   "You'd think that once a car is out in the lane it'll be off up the road. So did we. But the estate which had quit its parking space stood still before our bonnet, two white lamps came on at its rear, and the numbers on its plate became easier and easier to read.",
#:   "V2 left its position alongside the curb and entered V1's lane, where its operator braked to a stop. The reverse lights illuminated about half a second after it had come to rest. V2 then traveled rearward at low speed toward V1, which was stopped and sounding its horn.",
#:   "Bay 14 to control, can somebody tell the driver of that artic to look in his mirrors. He's come off the side into the lane, he's stopped, I've stopped behind him, and now he's bringing the whole lot back at me. I've a queue on my bumper and nowhere to go.",
#:   "The beeping is the clue. When you hear that from something which was parked a moment ago, left its slot in front of you and pulled up, it isn't a lorry getting ready to leave. It's one about to shrink your stopping distance from the other end, as this one is doing now.",
#:   "Our perception stack handles the first two thirds: parked van moves out into our lane, parked van comes to a halt. Then its velocity goes negative, the range to us falls although we're at zero, and the tracker throws the object out as implausible. Please build a scenario round exactly this.",
#:   "My grandmother never forgave the baker. His van came away from the shop and stopped on the road before our car, so far so good. Then he remembered the rolls, and instead of walking he drove it back, tail first, toward us, and she dropped her handbag on the handbrake.",
#:   "I was on my bicycle next to the robotaxi, and we both had to back-pedal, so to speak. A police car had swung off the kerb into the lane ahead and come to a stop. Its gears whined, and its boot started to travel toward us, faster than I could have walked.",
#:   "We had a parking spot in our sights, the one that the Škoda was leaving. It pulled forward into the lane and stood; we thought it was being polite. It turned out that the lady had changed her mind and wanted her spot again, for she came rearwards at us without a look.",
#:   "Six metres, five, four: the parking camera counted them off, and we had not moved an inch. It was the lorry in front that moved, back end foremost. A little earlier it had still been at the side of the road; it had pulled into our lane, halted, and had evidently thought better of the whole excursion.",
#:   "He was a tall man in a small car, and he did everything in fits. A fit brought him out from the pavement into our way; a second brought him to a stand there; and with the third, his arm over the seat back, he began to travel towards us in the wrong gear altogether.",
#:   "Kerb, lane, standstill, white lamps: the bus is backing on us!",
#:   "Parked Tesla out, halts, backs down the lane at the ego.",
#:   "left its space, stopped in front, came bum first at my bumper",
#:   "Its white lamps came on after it had come to a stand in our lane out of the lay-by, and its step neared our radiator.",
#:   "Actor parked right; leaves its bay ahead of us; velocity positive, zero, negative; our forward clearance sinks though our own speed is nil.",
#:   "The baker's lorry gave up its place by the kerb, gave up moving forward, and proceeded to give us a good view of its tailboard, ever closer.",
#:   "You stand behind a fire engine, you think it is leaving the kerb for good, it waits one blink, and suddenly your hood is its parking place.",
#:   "From parked, let the ambulance pull into the lane before the AV, pause there for half a second or so, and retreat towards the AV's bumper.",
#:   "I'd no quarrel with him leaving his slot nor with him stopping; it was the tow hook arriving at my plate from in front that I minded.",
#:   "The gear went in with a crunch that I heard over the radio. I'd let the estate out from in front of the chip shop, since I'm polite, and it had gone its own length and stopped. I was just thinking how nice and long the gap was. After the crunch the gap was getting eaten, from the wrong end, tail first.",
#:   "Where had her hat gone? Out of the window of the parked limousine, as it happened, at the very moment of leaving. Which explains why the limousine, no sooner in our lane, drew up again; and why its long black boot, with the flowers on top, bore down on us from ahead at a brisk walking pace.",
#:   "Chrome step, number plate, dirty rear doors: I had these at twelve metres, at eight, at five, and I wasn't moving. The box van they belonged to had been at the roadside until it saw me come. It had taken the lane, halted, and put itself in the only gear that could do me any harm.",
#:   "Dear neighbour, you'll find a small dent in my grille and a matching one in your towball. You will recall leaving the kerb outside number 12. You'll recall stopping, perhaps, on account of the cat. What you may not recall is me, waiting behind you in the lane, and you rolling rearward with your arm along the seat.",
#:   "There's a sequence of lamps you ought to learn. Single orange on the right-hand row: that coach wants out, and out it comes in front of you. Two reds: it's stopped. Two whites, and here's where you reach for the horn, because two whites mean that you're about to be visited by its engine.",
#:   "We took it for the getaway. The getaway got away about five metres: a black Transit slid out from the bank's kerb into our lane and stuck there. Someone was shouting inside that they had forgotten Kevin. And it came back for Kevin, blind, doors open, straight down the lane towards our front bumper.",
#:   "In the measurement you recognise three sections. In the first, the lorry detaches from the edge and takes the lane of the test car. The second shows it in rest, less than one second. In the third the distance between both reduces with one and a half metres per second, and this speed belongs alone to the lorry, which backs.",
#:   "I've a dashcam and a bad back, your honour, and both come from the same minute. The accused quitted his parking place. He stopped, well out, in front of me. I stopped likewise. Whereupon his vehicle advanced upon me hindmost, there being, he said, \"a better spot further down\", and I was in the spot.",
#:   "Bleep, bleep, bleep, said the big green lorry, and Tim said it was saying hello. It had been asleep beside the pavement; then it woke up and came on our road and stood. Mummy didn't think it was saying hello. Its back got bigger and bigger in our window and she pushed our own stick and we went back too.",
#:   "From the saddle you see all of it. Minicab at the rank, wheels turn, he's out into the lane in front of that driverless thing, and he brakes to a stop since his fare's waving from a doorway behind us. You could see him choose. Three-point turn? Nah. Gearstick back, neck twisted, and he's on his way at the pair of us.",
#:   "I was nice and parked up behind him for a breath, three yards, him out from the bus stop and standing, me happy. He'd forgot his sandwich box, they told us after. So he's dropped her into R and here's twelve tonne of single-decker giving me its backside, and all I've got is a hooter, and my mate yelling.",
#: ]
#: adversaries = ["car", "truck", "bus", "emergency-vehicle"]
#: requires = ["advKerb", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "stop", "reverse"]
#: position = "kerb"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 16.0
#: high = 34.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.4
#: high = 0.9
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_ADV_BACK_SPEED"
#: low = 0.8
#: high = 2.4
#: unit = "m/s"
#: meaning = "how fast it backs up"

param OPT_ADV_DISTANCE = Range(16, 34)
param OPT_BRAKE = Range(0.4, 0.9)
param OPT_ADV_BACK_SPEED = Range(0.8, 2.4)

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3) for 0.3 seconds
    do DrivePath(ownLane(egoRoute), 4.5) until abs(offsetFrom(ownLane(egoRoute), self)) < 1
    do BrakeOnPath(ownLane(egoRoute), globalParameters.OPT_BRAKE) until self.pose[3] < 0.05
    do Halt() for 0.6 seconds
    do ReverseStraight(globalParameters.OPT_ADV_BACK_SPEED) for 4 seconds
    do Halt()
