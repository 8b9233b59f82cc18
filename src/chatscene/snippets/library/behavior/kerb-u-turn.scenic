#: description = "The parked car pulls out and makes a U-turn across the road."
#: rephrasings = [
#:   "The parked car whips out and does a U-turn right across us.",
#:   "Vehicle 2 departed the curb and attempted a U-turn in front of vehicle 1.",
#:   "Parked veh, U-turn from roadside.",
#:   "The target starts from the parking strip and turns through 180 degrees across the VUT's path.",
#:   "It was parked and turns back on the street in front of us.",
#:   "A taxi at the stand spins round for a fare on the other side.",
#:   "The police car by the roadside wheels about to go after somebody.",
#:   "From his parking spot the biker loops over the whole road and heads back.",
#:   "Bloke parked at the side swung straight out and spun right round over the road without looking.",
#:   "Vehicle 2, parked curbside, pulled away and executed a U-turn across all lanes.",
#:   "Parked cab: off kerb -> 180 across road.",
#:   "The target leaves its kerbside position and immediately turns through 180 degrees across the VUT's path.",
#:   "The parked police car goes out and turns around on the street to other direction.",
#:   "From parked straight into a U-ey: actor sweeps across both directions from the kerb.",
#:   "He'd been sitting at the side; then he heaved the wheel over and brought it all the way about across the street in front of her.",
#:   "Watch him at the kerb, he's leaving his spot and going to flip round the other way right across you.",
#:   "parked car just pulled a uey straight off the curb across everyone",
#:   "A cab left the rank and turned about over the full width of the road, forcing traffic to halt.",
#:   "From a parked position you went directly into a turn that took you to the opposite side facing the other way?",
#:   "The parked lorry came out and straight away made U-turn on the whole road, no patience.",
#:   "Parked one second, facing the other way the next, and me with my foot through the floor.",
#:   "Full-width turnaround by vehicle departing kerbside position.",
#:   "PARKED CAR PULLS INSTANT U-TURN ACROSS TRAFFIC",
#:   "The parked motorbike looped from the kerb to face the other way.",
#:   "Cabbie leaves the rank and swings round to face the opposite way.",
#:   "Parked truck moves off, does a one-eighty over the road.",
#:   "The motorbike at the kerb starts up, leaves it and circles back.",
#:   "PARKED AMBULANCE SPINS AROUND IN FRONT OF TRAFFIC",
#:   "Roadside departure with immediate about-turn across the carriageway.",
#:   "Simulate a parked estate car that moves away from the side and keeps its wheel hard over until it is heading where we came from.",
#:   "A police car that had been lurking in a lay-by came out and turned tail across the whole road, just as we were arriving.",
#:   "The parked vehicle shall leave the kerb ahead of the VUT and, in one continuous arc, reverse its direction of travel across both lanes.",
#:   "Without so much as a glance over her shoulder she drove off from outside the bakery and turned her little car about in the street before me.",
#:   "The van which was standing on the right border is starting and does a half-turn on all the road, to go in the inverse direction.",
#:   "The lorry no longer stood by the kerb; it was swinging its great length out and round across us, to go off the other way.",
#:   "As I came up the high street a parked SUV started to move out from the left with no signal. I thought he'd join the queue like anybody else. He carried right on turning, over my lane and the opposite one, until he was pointing back towards town.",
#:   "Claimant's vehicle was travelling at 25 mph when the defendant's van, theretofore stationary at the roadside, moved off. It did not merge with the traffic but described a full half circle across the road, so as to drive away in the direction from which the claimant was coming.",
#:   "On my commute there's a spot where the dispatch riders wait, parked up by the sandwich shop. Today one of them got a job, fired up, pulled out and flipped round right across my wheel, so as to head for the other end of the street.",
#:   "We need a parked actor for the kerb suite. Trigger when the ego is near; it drives out of its bay and goes straight into a tight turn of 180 degrees that takes it through our lane, then leaves on the opposite side of the road.",
#:   "What you did there was right. You saw the front wheels of that parked taxi begin to move and you covered the brake; because he wasn't just moving off, was he, he was turning the whole thing round over both sides of the road.",
#:   "Kerbside to about-face in one lunge, our lane included.",
#:   "Motorbike quits its parking slot and doubles back across the street.",
#:   "Off the rank, wheel on full lock, facing home again: cabbie.",
#:   "The white Transit that had been dozing at the side woke up and came round in a great half circle right over both halves of the road.",
#:   "At the trigger the stationary kerbside vehicle pulls away and continues on constant steering lock until its heading has changed by 180 degrees.",
#:   "Who does that, go from parked to pointing the opposite way in one swoop with me bearing down on them?",
#:   "Aunty was sitting in parked car, suddenly she took it out and gave full round turning, so now she is going other direction.",
#:   "I want a fire engine to get going from the kerb and bring itself round, all in one sweep, until it's heading back down the street.",
#:   "Because his fare was on the opposite pavement, the taxi driver left the stand and turned his cab end for end in front of our bonnet.",
#:   "There's a tight bit by the library where folk pull in to drop off books. One of them, a hatchback, came out as I got close, and I lifted, supposing she was joining. I was looking at her front door next, then at her headlamps, and finally at her tail going off the way I'd come.",
#:   "It was the sidewalls of the front tyres that gave him away. They were turned right out before he moved, and when he did move the police car never straightened up: it came off the kerb, over our lane and over the other, and was off in the reverse direction with the siren starting up.",
#:   "The claimant, riding a bicycle, saw the parked estate set itself in motion. She assumed a simple departure. The defendant instead held his steering at full lock so that the estate swept the entire carriageway and came to face her, and she was obliged to mount the verge.",
#:   "Delivery riders, eh? One had his moped up against the railings outside the noodle bar. He gets on, kicks off, and instead of going my way like a normal person he wheels it about across the whole road, under my bumper, and buzzes away toward town.",
#:   "Test 11 covers departures from parking with reversal of direction. The target rests alongside the kerb ahead of the vehicle under test, sets off as the latter draws near, and traces a semicircle of about five metres' radius over its lane and the opposing one. The run ends when it has left on the far side.",
#:   "You've seen the driver in it, you've seen the exhaust, well done. Now what you thought was that he'd go in front of you and lead the way. Not a bit of it; look how his bonnet keeps on coming round. He's off back where we've been, the cheeky so-and-so, and we wait.",
#:   "Mum said a rude word. The lorry was sleeping next to the pavement and when we came it drove out and turned and turned and turned. I could see its one side and then its face and then its other side, and after that it drove to where we had been.",
#:   "There must have been a call on his radio, since nothing else would explain it. The ambulance had been parked up outside the café, crew eating chips; then it was broadside across the road ahead of me, still turning, and a few seconds later it went past my window in the other direction.",
#:   "The street was empty but for one long car beneath the lamps, drawn in at the kerb with its engine murmuring. As they came on it slid from its place and, with the slow contempt of a swan, turned itself wholly about over the road before them. Its lights blinded them; then it was behind them.",
#:   "With a forty-foot rig you want to know what the parked stuff is up to. This pickup moves off from the side and I think, right, he's going ahead of me. No chance. He's put it on full lock and brought it round over everything, mine and theirs, and I'm stood on the pedal watching him go by the other way.",
#:   "The Madrid office reports one strange case. A car what was parked at our right starts, and the planner believes that it will incorporate itself to our lane. But the car gives the whole turn over the road, our lane and the contrary lane, and it leaves in the direction from where our robot came.",
#:   "Parked facing our way; gone, over both lanes, the other.",
#:   "Scooter off the kerb, round we go, homeward bound.",
#:   "Kerb departure + full lock + 180: ambulance crosses our bows twice-wide",
#:   "At the start the pickup shows us its tail from the kerb, at the finish its headlamps from the other side of the street.",
#:   "One loop of the wheel took the parked roadster from the pavement on our right clean round the street and off where we'd come from.",
#:   "She has left the parking not to go with us but to make the half moon over all the street and to go home.",
#:   "All four of its sides passed before us in turn, tail, flank, nose, other flank, as the parked police car wheeled over the road and went.",
#:   "Do not let the parked lorry join the flow; let it come off the edge and carry right on round until it is headed the opposite way.",
#:   "You'd have laid money that the hatchback by the kerb was only edging out to see, till you saw it describe half a circle round your bonnet.",
#:   "I remember the sticker on her back window and I remember her St Christopher, which hangs on the front one. The only way you get to see both is if somebody at the kerb pulls out and keeps on pulling until she's come about over the whole road. Then she waved to me, going by, the other way.",
#:   "Put a plate on the table for the turning circle, he used to say, and ask yourself whether there's a plate's worth of road. That motorbike by the chemist's reckoned there was. It peeled away from the parked row, swept through our lane and the lane beyond, and its tail lamp went off along the opposite kerb behind us.",
#:   "The officers had been eating. What roused them we learned from the radio; what they did, we learned at once. Off the verge came the patrol car, across us it came, and I stopped with its whole length before me. The length shortened to a bonnet and grille, and the grille hurried past our window southward.",
#:   "What's wrong with the next roundabout, for heaven's sake? It's two hundred yards up. But no, the gentleman in the parked Bentley wants to be facing the sea and wants it now, and so off the kerb he comes with the wheel right round, taking in your lane and the one for the folk coming back. Seaward he goes.",
#:   "Before: one taxi at the right-hand kerb, tail towards us, roof light lit. After: one taxi at speed in the left-hand lane, tail away from us, roof light off, a lady in the back. Between the two there's a blur in our windscreen the width of the street, and four wheels all pointing round the same corner.",
#:   "I'd my ladder on the roof and it came through the windscreen, that's how sharp I stopped. The skip wagon at the kerb had started off. I said fine, he's away, I'll tuck in after him. But you can't tuck in after a thing that goes round like a gate, through you, through the far lane, and comes back past you.",
#:   "Arc length fifteen point seven metres, radius five, sense anticlockwise, initial condition parked. As the VUT approaches, the target quits the kerb and does not straighten when it has got to the VUT's lane; the arc is carried on over the opposing lane as far as the reversed heading, in which it then departs.",
#:   "Somebody whistled from across the street. It must have been a signal, because the ambulance at our kerb, that had shown no life, began to curl out. It curled before our bus, it curled over the tramlines, and it ended by the whistler, its nose pointing to where its tail had pointed and the engine pulling strongly away.",
#:   "The trace of rubber begins beside the parking meters on the east side. From there it makes a fair semicircle that spans the complete roadway and ends parallel to the west kerb, pointing south. V2 had been parked pointing north. V1's own marks are straight, eleven metres in length, and stop short of the semicircle.",
#:   "We were in a hurry, he was in more. Parked one moment, that courier; and I look at my watch; and there's his scooter athwart the road in front of me with the sole of his shoe on the ground for a pivot. Round she came. I got a \"sorry, love\" as he passed me on his way back to the depot.",
#:   "No indicator, no glance, only the front wheels, which were already folded over as far as they'd go while he still sat at the kerb. A careful driver would have read that. I read it when his Volvo was swinging through our lane, and by the time I'd come to rest it was finishing its swing on the far side and going home.",
#: ]
#: adversaries = ["car", "truck", "motorcycle", "emergency-vehicle"]
#: requires = ["advKerb", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: making a U-turn; own code"
#: [slots]
#: actions = ["pull-out", "u-turn"]
#: side = "right"
#: position = "kerb"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 14.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.5
#: high = 4.0
#: unit = "m/s"
#: meaning = "how fast it turns round"
#: [[parameters]]
#: name = "OPT_TURN_RADIUS"
#: low = 6.0
#: high = 7.0
#: unit = "m"
#: meaning = "the radius of its turn"

param OPT_ADV_DISTANCE = Range(14, 30)
param OPT_ADV_SPEED = Range(2.5, 4)
param OPT_TURN_RADIUS = Range(6, 7)

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 4) for 0.4 seconds
    do TurnOff(3.1, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_TURN_RADIUS)
    do MoveAhead(6)
