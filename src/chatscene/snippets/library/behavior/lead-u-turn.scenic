#: description = "The car ahead brakes and makes a U-turn across the road."
#: rephrasings = [
#:   "The car in front of us slams on and flips a U-turn.",
#:   "Vehicle 2 attempted a U-turn from the travel lane in front of vehicle 1.",
#:   "Lead brakes hard, U-turn left.",
#:   "The target decelerates strongly and turns round through 180 degrees ahead of the VUT.",
#:   "It makes a big brake and is turning back the whole way on the street.",
#:   "The taxi before us sees a fare on the other side and whips around.",
#:   "The police car ahead does an about-turn right there to chase someone.",
#:   "A motorcyclist in front checks hard, then doubles back the way he came.",
#:   "The car in front dabbed the brakes and spun round to go back the way we'd come.",
#:   "The lead vehicle slowed and made a U-turn, blocking both directions of travel.",
#:   "Truck ahead slows, turns about, now facing us.",
#:   "The lead vehicle decelerates and performs a 180-degree turn across the carriageway.",
#:   "The bus before me brakes and turns around to the other direction.",
#:   "Lead in same lane flips heading by 180 and leaves in the opposite direction.",
#:   "He had forgotten something, it seemed, for he slowed, wheeled right about in front of her and headed home.",
#:   "Squad car in front is flipping around, hold back till he's facing the other way.",
#:   "he braked in front of me and pulled a full 180 across the street",
#:   "The car ahead slowed and then doubled back across both lanes.",
#:   "The leading vehicle checked its speed and, in full view of my client, put itself about to return whence it came.",
#:   "Front taxi slow down then make U-turn just like that, block whole road.",
#:   "Realises he's going the wrong way, on with the brakes and he's turning the whole shebang round in front of me.",
#:   "Direction reversal of preceding vehicle across the carriageway after braking",
#:   "GPS said TURN AROUND so he did, right in front of me",
#:   "The van in front slows and swivels about across the street.",
#:   "Cab ahead brakes and swings right round, now facing our way.",
#:   "Leading van slows, comes about, heads back where it came from.",
#:   "Have the ambulance in front brake and U-ie across the street.",
#:   "Biker up front checks his speed, loops round across the road.",
#:   "driver in front realised braked did a uey over both lanes",
#:   "We had been behind the coach for a mile when it hauled its speed down and turned itself round completely, sweeping its long side across the road.",
#:   "The lead target reduces its speed strongly and then reverses its heading through a full half circle, leaving in the opposite direction on the other side.",
#:   "Careful with taxis, because if one in front of you brakes with no reason he's probably about to spin the wheel and go back the other way.",
#:   "The vehicle which was driving before me has made a braking and then a half-tour on the avenue, cutting all the street in order to go home.",
#:   "Control, the pickup I was following has dropped anchor and flipped round through one-eighty, he's facing the way we came, over.",
#:   "Was my client to foresee that the lorry in front, having braked, would wheel about in the roadway and present its flank to her?",
#:   "He must have seen the parking spot on the far side, for the man in the little red hatchback ahead of me lifted, braked, and cranked the wheel as far as it would go. Round he came, over the centre line, until I was looking at his headlights.",
#:   "V1 was following V2, a motorcycle, at about forty feet. The operator of V2 braked to a near stop and turned through 180 degrees to the left across the roadway in order to travel back in the direction from which both vehicles had come. V1's driver had little time.",
#:   "Now a fire engine doesn't turn on a sixpence, but ours in front had evidently been sent to the wrong end of town. Its brake lights glared, it nearly halted, and then it came ponderously round across the whole width of the street to go back for the other end.",
#:   "Scenario request from the taxi-rank pilot: the lead car, travelling in the ego's lane ahead, decelerates sharply and performs a turn-around over the opposing lane, ending up driving toward where the ego came from. For part of this time it is broadside on and fills the road.",
#:   "Dash cam comment: everyone's slating the SUV but cammer was too close. Yes, it braked in front of him, and yes, it then doubled round on itself across the road like it owned the place, but if you leave two seconds you simply sit and watch it finish.",
#:   "Lorry ahead sheds speed and hauls itself round to face us.",
#:   "I want the police car ahead to brake, then whip about over the road.",
#:   "Cab brakes. Cab does a full 180. Cab now going home.",
#:   "The scooter before us slowed almost to nothing, laid itself over, and drew a half circle right across the street, until it was pointed at where we'd come from.",
#:   "The target preceding the VUT brakes to near standstill and then traverses the carriageway in a turn of approximately 180 degrees, departing in the reverse direction.",
#:   "Front car braked heavily, I thought it's for signal, but he turned whole vehicle round, covering both sides of road, and went back from where we all came.",
#:   "That's a fire engine that's missed its turning: brakes on, wheel hard over, and round it comes, right the way over both halves of the road.",
#:   "My client was entitled to assume that the estate car ahead of her, when it slowed, would go on in some forward direction and not about-face across the street.",
#:   "If his face is now towards you and his number plate's the front one, it's because he has braked and swung clean round across the road, that pickup.",
#:   "A dog had got out, we learned later. All we knew was that the jeep we were following began to brake where there was nothing to brake for. It slewed across the middle, and across the far side, and kept coming round; for a second I had its door, then its headlamps, and with that it was gone up the opposite side of the street.",
#:   "V2 was the lead vehicle in the eastbound lane. Its operator reduced speed to approximately 5 mph, turned the steering wheel to full lock and took V2 around, over the centerline and the westbound lane, until it was westbound itself. V1's view of V2 was broadside for about two seconds.",
#:   "Test idea from the ambulance people: crew gets redirected mid-run. The ambulance is our lead. It brakes firmly, describes a half-circle over the whole width of the road, and sets off towards where the ego has come from. The ego mustn't nip through behind its tail while it's still swinging.",
#:   "Blimey, that biker. He'd forgotten his sandwiches or something, because he hit the brakes just in front of me and I could see him look over both shoulders. Then he peeled round in one go, the full circle's half, kerb to kerb across the road, and that was him bound for home.",
#:   "It was a long truck for so short a thought. The driver of it, whom Oskar had been behind since the mill, must have changed his mind; the stop lights glowed, the speed fell away. Then came the cab, around, and the load, around, until the street was shut like a gate and the gate moved off eastward.",
#:   "She won't thank me for telling you, but the wife had seen a hat in a window. I was following my brother-in-law's Volvo, with her in it. Brake lights; and that Volvo goes right about, the full sweep, over the other half of the road as well. Back to the hat they went, and left me stood there.",
#:   "I don't get why people panic with these. Taxi's in front, brakes for a fare waving from the pavement opposite. His wheels are at full lock, so you know. You leave him the whole street, because he needs the whole street, and when he's finished you're looking at one another, and he's off the way you've been.",
#:   "The accident sketch, drawn by the claimant's son, shows the van in three positions. In A it's ahead of us with its brake lamps coloured red. In B it lies athwart the road like a log. In C, on the opposite side, its arrow points down the page, where A's and ours point up.",
#:   "From the seat of an HGV I can see when a motorist is lost. This one in the yellow hatchback kept tipping his head, so I was ready. He slowed right down in front of me, then spun the thing about, using my lane, the other lane, and a bit of the verge, and drove off back toward the motorway.",
#:   "Copper in front of us got a call, you could hear it through the window. He stood it on its nose, heaved at the wheel, and had that patrol car round and pointing south before we'd stopped, and I mean all the way round, from our side over to theirs. Siren on, gone.",
#:   "There is tyre dust on the road in the form of a horseshoe. One leg lies in the lane in which the claimant was following; before it begins there is a faint braking trace. The other leg lies in the lane for the opposite direction. That, I say, is the path of the motorcycle in front.",
#:   "Taxi before us anchors, loops, heads home past nobody's leave.",
#:   "Lead rider brakes, carves a half circle over both lanes.",
#:   "Tail lamps, flank, headlamps: the van's turned about.",
#:   "I followed its rear for a mile, then red lamps, then I'd its side across the entire road, and by the time I'd stopped I was looking at its grille.",
#:   "The lead truck drops nearly to a stop, puts its wheel hard over, and sweeps through a hundred and eighty degrees to the opposite carriageway.",
#:   "As they'd been called to an address they had just passed, the crew in front of us stood on the brake and took the ambulance round to face whence it came.",
#:   "Simulate the lost tourist: he is leading the ego, he looks at his phone, he slows sharply, and he brings the car about over the whole width of the street.",
#:   "The number plate I first gave you, officer, was yellow and the second was white, being the same car's; it'd braked before me and whipped round to go the other way.",
#:   "Can you see he's slowed and is craning his neck? He's lost, he's not turning off anywhere, he's coming right about, so let him finish.",
#:   "One learns a lot about a pickup in seven seconds. At the start of them it was leading us and showed a tow hook and two red lamps, very bright. In the middle it lay broadside over either half of the road and showed us its door. At the end it showed its radiator, and the lady in it waved, and was gone to where we'd come from.",
#:   "My satnav says that too, \"make a U-turn where possible\", and I ignore it. The man on the motorbike, two lengths ahead of my cab, obeys his. His front end went down, so I backed off. Then he leaned into an arc that started in our lane and finished in the oncoming one, and he burbled off to where he'd been.",
#:   "The kink in the gas main works explains the place. V1 was behind V2, a squad car. V2's operator received a call, applied the brakes firmly, and came about to the left through the full width of Route 9, departing south. V1, northbound, had braked to 4 mph. The tire marks of V2 form a near-perfect half circle.",
#:   "Never have I seen so much of a lorry. We were behind it; it was braked, strongly, and I thought of a hare. Next its cab left the picture at one edge and came back into it at the other, with the trailer strung over the road like a gate between. We sat at the gate. After which it trundled off in the wrong direction, for us.",
#:   "On the dash-cam reel it is number two. \"Watch the white hatchback ahead. He's realised. Brakes! Here's his passenger door, hello passenger. Here's his other half of the road, nobody on it, lucky. And here's his face, coming back along it.\" Somebody in the comments asks where the driveway was. There's none, he just came round.",
#:   "She would be in a great rush to be somewhere else than where she was going, the young lady. I was behind. Her brake lights went on as if she'd seen the devil. She didn't stand, though, or not for long: round she came, kerb to kerb, and drove back up the hill with her window open, still talking on the telephone.",
#:   "I have the order from the log: preceding object, deceleration strong, speed almost nought; then the object's yaw starts to run, 20 degrees, 70, 120, 180, while its box lies over our lane and the contrary one; then the same ID is \"oncoming\" with growing speed. Our classifier gave it a new ID at 90. That's the bug.",
#:   "The engine passed us, no, listen, it had been in front the whole time, that's what confuses everyone. It was leading, number 14, heading out. Then a squeal from under it and the men's helmets all swung together, and the great red thing wheeled about across the road. Only then did it pass us, heading in.",
#:   "Someone forgot the dog, we reckon. We'd been tootling along behind this estate car since the campsite. It braked, and I mean braked, my own dog hit the grid; it made a big loop over the oncoming side, up to the far verge, and it fairly flew back the way we'd all come. There wasn't a junction for miles.",
#:   "It's the lead vehicle's nose you want to plot. Pointing away from the ego for the first three seconds. Slowing, quite hard, in the fourth. Then let it sweep round, left through the opposing lane, like the hand of a clock from twelve to six. Once it is on six, send the thing off down the other carriageway.",
#:   "In the Spanish villages the dustcart has the custom to forget a street. I was going after it. All at once the red lights, strong. I stopped well. And the cart, with its two men hanging behind, has drawn a big letter U over the road, one wheel on the sidewalk, and the two men have greeted me when they came past.",
#: ]
#: adversaries = ["car", "truck", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: making a U-turn; own code"
#: [slots]
#: actions = ["u-turn"]
#: place = "road"
#: position = "ahead"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 15.0
#: high = 35.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.6
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.2
#: high = 3.2
#: unit = "m/s"
#: meaning = "how fast it turns round"
#: [[parameters]]
#: name = "OPT_TURN_RADIUS"
#: low = 6.0
#: high = 7.0
#: unit = "m"
#: meaning = "the radius of its turn"

param OPT_ADV_DISTANCE = Range(15, 35)
param OPT_BRAKE = Range(0.6, 1)
param OPT_ADV_SPEED = Range(2.2, 3.2)
param OPT_TURN_RADIUS = Range(6, 7)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.5
    do TurnOff(3.1, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_TURN_RADIUS)
    do MoveAhead(7)
