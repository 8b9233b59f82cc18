#: description = "The oncoming car accelerates into a left turn across the ego's path."
#: rephrasings = [
#:   "he thinks he can make the left before us and floors it",
#:   "Vehicle 2, stopped opposite, accelerated into a left turn in front of Vehicle 1.",
#:   "opposing veh, left turn, full throttle, misjudged gap",
#:   "The oncoming target, waiting to turn, accelerates left across the path of the VUT.",
#:   "The motorcycle in front of us accelerates strong and turns left before the ego passes.",
#:   "A biker facing us gambles on a quick left and opens it up.",
#:   "The ambulance opposite swings left in a hurry, siren on.",
#:   "Jumping the gap, it darts leftward ahead of us with spinning wheels.",
#:   "The git coming the other way gunned it and whipped left across me to beat me through.",
#:   "The opposing vehicle accelerated and turned left in front of Unit 1, failing to yield.",
#:   "Opp. moto floors it, L-turn across ego's bow.",
#:   "The oncoming target increases speed while turning left across the trajectory of the VUT.",
#:   "The car against me gives much gas and turns quick left before me.",
#:   "Left-turn-across-path with throttle: opposite actor tries to beat us through the gap, speeds up in the turn.",
#:   "He saw a gap that wasn't there, put his foot to the floor and flung it left across her road.",
#:   "He thinks he can make it, he's going for the gap, racing his left turn in front of you!",
#:   "guy coming at us floored it to make his left before us. he barely did",
#:   "The approaching sports car put on speed to snatch a left turn ahead of traffic.",
#:   "Seeing her approach, you chose to quicken and turn left before her rather than wait?",
#:   "Opposite car wanted to turn left fast fast before me, so he raced across my front.",
#:   "Sees me coming, so he gives it the lot and slings it left over my bows.",
#:   "Accelerated left turn of opposing vehicle across ego path.",
#:   "RACES TO BEAT ME ON A LEFT TURN",
#:   "The oncoming motorbike pounced left over our path.",
#:   "Oncoming sports car speeds up and hooks left through our path.",
#:   "Bike opposite hurries left ahead of us with the throttle open.",
#:   "Police car facing us guns it into a left turn.",
#:   "TOO CLOSE: he blasts left across me from the opposite lane",
#:   "Ambulance from ahead, left turn under hard acceleration, our path crossed.",
#:   "The saloon facing me had been waiting to turn, and just as I got there it leapt forward and took its left turn under full power.",
#:   "Let an oncoming motorbike wind up the engine and dash left over the intersection, so as to be across before the robotaxi arrives.",
#:   "Facing the vehicle under test, the target commences its left turn late and with strongly rising speed, thereby crossing the path of the test vehicle.",
#:   "he was opposite me blinker on quite patient then suddenly lost it stamped on the accelerater and shot left in front of my car",
#:   "The car from the front must turn left and he believes he arrives before me, therefore he accelerates very strong in the curve.",
#:   "Fire engine coming the other way is going left across you in a hurry, it's picking up speed through the bend, so let it have the road.",
#:   "My light was green. A hatchback coming towards me had slowed at the mouth of the junction, wanting to go left. When I was nearly upon it the driver put on a great spurt and raced round across my front wheels.",
#:   "V2, approaching from the opposite direction, slowed for its left turn and then, instead of yielding, accelerated at full throttle. It passed across V1's lane while still gaining speed, and it cleared by less than a metre, as the intersection camera shows.",
#:   "It is a race against us, basically. The opposing motorcyclist sees that the AV is close, reckons that with enough power he will be through in time, and so twists the grip and leans left over our lane, going quicker with every metre of the turn.",
#:   "He'd better look at his insurance, that one. Stood there opposite me like butter wouldn't melt, waits till I'm on top of him, then plants his right foot and slews left over my bonnet with his tyres smoking. I stood a twenty-six tonner on its nose.",
#:   "She saw the patrol car come on from the far side of the square, brake, and gather itself. Then its siren gave a whoop, it surged ahead and flung itself leftward, over the very stones she was about to drive on, its engine climbing all the way.",
#:   "Opposing biker sees us, pins it, slashes left over our way.",
#:   "Facing car snatches a left before us, wheels spinning through it.",
#:   "Left turn at full chat by oncoming police car, our path cut.",
#:   "The coupe opposite had the whole evening to make its left, and chose to blast through it when I was twenty yards off.",
#:   "Counter-directional target yields initially, then applies full throttle and sweeps left through the ego trajectory with speed rising until clear.",
#:   "You thought the motorbike facing you would let you by, didn't you, instead of opening the taps and whipping left in front of you?",
#:   "Opposite side ambulance was wanting left, he slowed, then full race he gave and took the turn in front of my bonnet only.",
#:   "Give the oncoming hatchback some nerve: it ought to bide its time, then stamp on the gas and scorch left across our route.",
#:   "\"He put his foot down to get his left in before mine came by,\" said a postman who had watched the facing Alfa from the corner.",
#:   "I know he saw me since he'd been sitting there looking straight at me, wheels pointing over towards the side street. At forty yards I took it as settled. At thirty his bonnet rose, and by the time I was on the brakes he was broadside and going like stink into the left-hand road.",
#:   "The junction camera shows V2 opposite V1 with its left indicator on, slowing almost to a stop. As V1 entered, V2's rear squatted and its wheels spun. V2 then described a left-hand arc in front of V1 with growing speed and left by the side road; the clearance was eighty centimetres.",
#:   "There's no prize for getting your left turn in first, but try telling this fellow coming the other way. He's hung back, he's measured you, and now he's giving it everything it has got and hurling the thing round across your bows. Brake. Let him win.",
#:   "My bicycle has no horn, so I shouted. The scooter coming from ahead had put its blinker to the left and I thought she was waiting for me and for the robotaxi. She was not. With a scream of that little motor she tore round over both our lanes, always faster, and away down the lane.",
#:   "It is our most aggressive variant of the left turn across path. Rather than trickling or pausing, the opposing actor, having slowed at the mouth, goes for maximum throttle on a gap that is objectively too short. It accelerates throughout the arc in front of the AV and so just about scrapes by.",
#:   "Something blue and loud was over there on the other side of the junction, nose towards us. Uncle said it will let us through. It said WHOOP, and it got fast, and it went round in front of our window to the left so quick that I saw only a stripe.",
#:   "That gap was mine, by right and by physics. What took it away was a yellow Seat that had been slowing opposite, apparently to let me have it. Its driver had a fit of courage. With the tyres squealing under the power she brought it round to her left across me, faster at the end than at the beginning.",
#:   "Log 88: time to conflict 2.3 s and falling; opposing object speed 1 m/s, yaw rate nil. Next: speed 4, yaw left. Next: speed 8, yaw hard left, position on our centreline. Next: out of our lane on the right-hand side. In plain English, the motorcyclist beat us to it with his left turn.",
#:   "He who comes from the front and will go to the left must wait, this every child learns at us. The man in the Porsche has waited three seconds. Then he gave so much gas that the back went sideways, and he bent to the left directly before my car, quicker and quicker.",
#:   "The old square had seen duels before. At one end of it stood the van; at the other, facing, a motorbike that had checked its pace and seemed to bow. It was no bow. The engine rose to a shriek, and the machine came leaning round, leftward, over the very line the van was on, gathering pace.",
#:   "You'll see in the dash-cam that I never get near it, but that's because I was on the anchors. Fire chief's car, coming the other way, wants the turning that's on his left. Brakes for it nicely. Sees me, thinks now or never, boots it and goes flying through it across my front.",
#:   "Opposing biker cracks it open and dives left over our nose.",
#:   "Sees gap, no gap really, left across us at full chat.",
#:   "Blue lights opposite: brake, squat, scream left through our path.",
#:   "The coupe facing us had all but stopped for its left, and from that all-but-stop it launched round over our line with wheels smoking.",
#:   "It's her left flank we nearly hit, which tells you that she'd swung over in front, and the tyre howl tells you with how much power.",
#:   "Opposite ambulance makes its left by boot rather than by patience, gathering speed through the arc so as to be over before our bumper's there.",
#:   "He waits against me with his blinker, he does not wait enough; with whole gas he pulls to his left through the hole before my car.",
#:   "Let the opposing scooter ease up at the turning, judge the ego's distance wrongly and dart off to its left across the ego, ever quicker.",
#:   "When you ought to have stayed put and let the bus by, you had your foot flat on the floor and your wheel hard to the left?",
#:   "I was already saying thank you, I do that, with one finger off the wheel, since the car coming the other way had slowed down to let me by before he turned. I was thanking thin air. There was a roar, and he was a streak from right to left, no, his left, across my front, into Garden Street.",
#:   "The winker on the motorbike facing us had been going since the pub, and it was going left, and so we knew where, just not when. When turned out to be the worst time possible. The wheel lifted, actually lifted, and it went over our bows at an angle with the man lying on it and the engine begging for mercy.",
#:   "Rule number one for the sort who's opposite you with his left indicator on: never mind his indicator, mind his bonnet. Flat is fine. Going up, like that, means power, and power means that he'll try it. Brake now. There he is, side on, nipping round through our bit of road and hurrying all the more on the way out.",
#:   "The trigger for the opponent is the ego's distance to the conflict point. Until then it loiters at the junction mouth, opposite, having slowed. At the trigger it applies maximum throttle while following its left-turn path; it crosses the ego lane with rising speed, reaching nine metres a second. A polite opponent is in scenario 9, not here.",
#:   "From the fire chief's dash camera you'd get the impression he was chased. There's our bus ahead of him, nearing. The view rocks back, you hear the engine flare, and the whole world pans to the right as he's slung himself to the left. Our radiator goes through the picture, big as a house, and the side street opens.",
#:   "Who'd won wasn't clear until the rubber had cleared. We were stationary with our nose on the zebra. The cab that'd been dawdling up to the crossing from the other end was forty yards along the street to our right, its left as it came, and still accelerating. Between us and it ran two wet-looking curved stripes.",
#:   "Grit pinged off my headlamps, and that was the closest we came. It had been thrown up by the rear wheel of a trail bike, which, having met me at the crossroads and hung there a bit, gunned it for the track on its left. It was across my lane the whole of a quarter of a second, and gone faster than it'd crossed.",
#:   "Investigators asked why V1 had no time to respond. V2, opposed to V1, decelerated on its approach to the intersection, which V1's driver took for yielding. The throttle position of V2 then went from 0 to 100 within 0.3 s, with steering to the left. V2 passed through V1's lane at a speed that rose from 6 to 29 km/h.",
#:   "Elderly ladies aren't supposed to do wheelspin. This one, in a Honda, was coming the other way and had put her brakes on for the bridge road. I trundled up thinking she'd all the time in the world. Evidently she hadn't. There was that shriek of tyres, her little face, her left side, her boot, and the bridge road had her.",
#:   "The city's robotaxi braked so strongly on Tuesday that a guest lost her tea. Our reporter sat beside her. A police motorcycle had been drawing near from in front and had checked, as to let us pass. What followed was a bellow, a lean, and a white flash going left-handed over our path, each yard of it faster than the yard before.",
#:   "You can see why he thought it would work, there's a car's width of day between us and the kerb he wanted. So the Golf over the way, that'd been rolling up to its turn like a lamb, gets the spurs. It comes round left, tail hanging out, through the day. When there's no more day he's out of the other end, flat out.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "NHTSA pre-crash typology: left turn across path, opposite direction; own code"
#: [slots]
#: actions = ["oncoming", "accelerate", "turn-left"]
#: position = "oncoming"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it accelerates"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.3
#: high = 0.6
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_THROTTLE = Range(0.3, 0.6)

advTurn = "left-turn"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, 9)
