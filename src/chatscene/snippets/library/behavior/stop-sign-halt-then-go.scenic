#: description = "The crossing car stops at the line, waits, and pulls out in front of the ego at full throttle."
#: rephrasings = [
#:   "he stops at the sign all nicely and then goes right when we get there",
#:   "Vehicle 2 stopped at the stop sign, then accelerated into the path of Vehicle 1.",
#:   "halts at line, waits, then launches into us",
#:   "The target comes to a complete standstill at the stop line and starts into the junction when the VUT approaches.",
#:   "The truck makes the stop on the line, and when we are near it starts with much gas.",
#:   "A van pulls up at the give-way line, has a look, and bolts out regardless.",
#:   "The biker waits at the stop line and then rockets off under the ego's nose.",
#:   "Having stood for a while, the bus sets off without giving way.",
#:   "he stopped at the line good as gold, waited till I was nearly there and then floored it out in front of me",
#:   "V2 came to a complete stop at the stop line, waited, and then accelerated rapidly into V1's path.",
#:   "MC: full stop at line, waits, then flat out across our nose.",
#:   "The crossing target stops at the line, dwells, and departs ahead of the VUT under maximum acceleration.",
#:   "The truck stands correct at the stop line, but when I come he goes out with full gas before me.",
#:   "Legal stop, illegal go: NPC holds v=0 at the sign, then launches with 100 % throttle when the SUT is close.",
#:   "It had halted as the sign bade it and waited so long they took it for granted; then it sprang out before them.",
#:   "Lovely stop at the sign, full marks, looks both ways... and he pulls out on you pedal to the metal. Zero marks.",
#:   "he stopped at the line, waited for us to get close, THEN floored it out",
#:   "A van observed the stop line, bided its time, and then leapt out before an approaching nurse",
#:   "You had stopped, as you should, and waited; why then did you emerge at full power before my client?",
#:   "He stopped at stop line properly, waited some time, then when we come he zoomed out in front",
#:   "Stops like a good boy, waits, waits, and just as I'm on him he drops the clutch and he's out",
#:   "Compliant stop-line halt followed by mistimed full-throttle emergence",
#:   "Driver stops, WAITS, then launches out in front of me",
#:   "The truck sat at the line, then pounced.",
#:   "Halts at the give-way line, bides, then full beans across our bows.",
#:   "Crossing moped: stop at line, pause, max throttle out before ego.",
#:   "It stops correct, attends a while, and then leaves with all the gas.",
#:   "Bus obeys the stop line, lingers, then lunges out ahead, foot flat.",
#:   "Let it wait at the line until we're near, then explode outward.",
#:   "A van from the side road came to rest at its stop line, stayed put till I was nearly on it, and then roared out ahead of me.",
#:   "The pickup did all that the sign demands, a proper stop and a good long look, and threw it away by flooring it out before us.",
#:   "Crossing target to be stationary at the line for at least 0.4 s, and then released at full throttle into the VUT's path on the trigger.",
#:   "That truck's standing at his line, he has been for a while, so you think you're safe, and out he comes with his boot to the floor.",
#:   "With brakes squeaking the coach had stopped at the white line; everyone was sure it would let the robotaxi by; then it charged out in front, engine bawling.",
#:   "Riding home, I saw the cabbie stop at the line, catch my eye, wait, and then wind it up to full power straight across my front wheel.",
#:   "A motorcyclist was waiting at the mouth of Station Road. He'd stopped behind the line and had one boot on the ground, so I kept on. It was when there were only a few car lengths between us that he tore out in front of me with his throttle wide open.",
#:   "The stop was textbook: V2's recorder gives zero speed, front axle just short of the line, for almost three seconds. The accelerator position then goes from zero to one hundred per cent, and V2 enters the intersection directly ahead of V1, which had no stop sign.",
#:   "Where is the sense in it? He had waited. He had stood there at the line with his lorry like a lamb while the whole road was empty, and he chose the one moment when somebody was coming, me, to put everything the engine had through those wheels and come out.",
#:   "Caller says a silver saloon on the side street pulled up at the stop line like it should and sat there. As caller's vehicle drew near, it took off at full power right out in front of her. Caller braked in time, no injuries, requests no unit.",
#:   "In my village we call it the cat's way of crossing. The little bus came up to its line, it crouched there and did not stir, we came closer, it did not stir, and when we were as good as there it sprang out in front with all its might.",
#:   "Waits at its stop line, then launches flat out before us.",
#:   "motorbike stops, sits, sits, then full send across my bow",
#:   "Lorry halts at the line, bides its time, bolts out ahead of ego.",
#:   "The coupe had stood obediently at the end of the side street, and when we were nearly level with it, it burst out in front with the engine screaming.",
#:   "The intersecting vehicle is held stationary at its stop line and, when the ego reaches the trigger point, is released into its path with the pedal at 100 %.",
#:   "He's stopped at his sign, nicely done, he's having a wait, and no, no, he's gone for it, foot to the floor, right before your nose!",
#:   "So this guy in a BMW actually stops for the stop sign, hangs out there until I'm like five cars away and then punches it out ahead",
#:   "That bus was standing on the line properly, we thought he's waiting for us, but when we reached near he has come out in front with full accelerator.",
#:   "Make the van from the side road come to a complete stop at the line, stay there, and then pull out ahead of our car on maximum power.",
#:   "His front wheels were on the paint when I first saw him, and they stayed on the paint. I'd looked at them the whole way down, as you do, and I was all but there when they spun. There was blue smoke where the scooter had been, and in front of my radiator there was the scooter, being given everything it had.",
#:   "Insured states that the third party was stationary at the mouth of Cow Lane behind the stop line. The third party allowed two cars to pass and remained where he was. Upon insured's vehicle drawing near he emerged into its path under fierce acceleration, and insured swerved into the bus shelter.",
#:   "Two sounds, if you'd like it the way a blind man tells it. The first was a lorry on my left letting its air go at the stop line, and then nothing but its idling, for quite a time. The second was that same engine bellowing for all it was worth, out into the road, just as the car from the right got to us.",
#:   "If he'd been going to do it he should have done it at once. He had a whole street to himself while he stood at that line, this fellow in the hatchback, and he used it to adjust his glasses. I arrive, and now he's ready; out he hurtles, tyres yelping, slap in front of me.",
#:   "V2 complied with the stop sign, its speed being zero for 4.1 seconds with the front axle at the stop bar. V1, which had no control, was forty-five feet from the intersection when V2 was accelerated at the maximum rate of which it was capable. V2 entered the path of V1.",
#:   "I've told it in the pub so often that the wife does the noises. A coach waiting at the line, engine going pocketa pocketa, driver looking me bang in the eye. Me coming up, nice and gentle, thinking what a civil man; and then roar, and there are fifty-three seats and a toilet going across my front with the taps wide open.",
#:   "What the planner took for a yield was an ambush. The track from the minor arm shows a clean deceleration, a full stop at the line and several seconds of nothing, during which its class was changed to \"waiting\". At an ego distance of eighteen metres it left the line with four metres per second squared, immediately before us.",
#:   "I am coming on the big road and at the small road there is a motorbike on the white line, quiet, with the foot on the floor. He lets pass the bus, he lets pass the lady, he is a saint, I think. And for me he opens all the gas and springs out directly before my wheels.",
#:   "You stopped? Yes. You could see Mrs Hale approaching? I could. And you went on waiting until she was almost upon you, at which point, on the evidence of your own black box, you pressed the accelerator as far as it would go and drove out in front of her?",
#:   "A cat will sit before a gap in the fence for an hour and choose the moment when the dog comes by. There had been nothing on the main road since they'd caught sight of the pickup, drawn up at its line, dutiful, unmoving. Only when they were at hand did it hurl itself out before them with all its horses.",
#:   "Riding to work on the main drag I clock a taxi at the give-way, wheels not turning, proper stop behind the line. Car ahead of me's the one he's been saving himself up for. They're maybe three lengths apart and he drops it and blasts out in front of them, I could smell the clutch from back here.",
#:   "Stands at his line till we're there, then pedal to metal.",
#:   "Stop line, patience, more patience, then a cannon shot ahead.",
#:   "Halted taxi waits for us and then blasts out before us.",
#:   "For three seconds I'd eyed a motionless bumper at the stop line, and then without a change of expression it was crossing my bonnet under full power.",
#:   "Side-road van: brake to zero at the line, dwell until the ego's distance trigger, then maximum throttle out across the ego's path.",
#:   "he STOPPED. like a legend. i even thanked him in my head. then when im basically level he sends it out infront of me, wheels spinning, WHY",
#:   "At the line he was standing peacefully, two scooters he let go, I also thought my turn; then full race he gave and in my front he came out.",
#:   "I can forgive the not stopping, said the biker, but this lorry had stopped, had a rest, and saved all its horsepower for the moment when I got there.",
#:   "Who on earth obeys a stop sign that well, sits out the whole empty road behind his line, and then floors it right across a coach?",
#:   "His bonnet was so still that there was a pigeon on it. I give you my word, a hire car, at the line where the lane comes out, waiting, with a pigeon. I was two lengths off when the pigeon went straight up. The bonnet came straight out, and up as well, with a howl, and I missed the back of it by the width of that bird.",
#:   "On the garage's tape there's a squeak as the pickup pulls up at the line, then just sparrows, for so long that you'd forget about it. You hear a car coming along the main road, louder; that's us. And when we're at our loudest there's an engine drowning us out, being thrashed, right across our front, and a scream of tyres, which is ours.",
#:   "Let me go through it as the examiner would. Did the vehicle from the side come to a full stop? It did. At the line? Not an inch beyond. Did it wait for us? To begin with. I'd have ticked every box down to the last one, \"gives priority to traffic\", and I'd my pen on that when it took off under our bumper with its foot hard down.",
#:   "At 40 m: tracked motorcycle on the intersecting arm, v = 0, position 0.3 m behind the line, since eleven seconds. At 25 m, the same. At 17 m it leaves the line. The value in the acceleration column is the highest in the whole campaign, and the direction is across our front; we classify a vehicle as yielding after three seconds at rest and perhaps we should not.",
#:   "My wife waves people out, she's a kind woman, but I tell you she hadn't waved. The minibus had pulled up at the end of the drive, at the line they've painted there. The driver looked left, looked right, folded his paper. He'd been standing there so long, we'd stopped seeing him; the next we saw was MOUNT PLEASANT OUTING, in capitals, going past our headlamps with everything it had.",
#:   "Nine hundred hours of dash cam and this is the only one where the bad guy does the good thing first. Proper stop. Both axles behind the paint. Even the hand brake, you can see him rock. I'm coming up the main road, he has a look at me, has another look at me, and at four lengths he dumps the lot and launches clean over in front of me.",
#:   "From the bus shelter I'd had that coupe before me for a minute. It was waiting behind its line and the man was growling at it, in neutral. The main road was as bare as my hand. Then came a red car with an old couple in, and at once he let it go, flat out, right across their noses; that's what he'd waited for, I think.",
#:   "A horsebox doesn't jump, as a rule. I was in my cab on the main road and this horsebox was at the side, at its line, at a stand, with the girl looking at me, calm. I'd got to where I could see her earrings. Away went her clutch, black smoke out of the back, and it jumped, out, dead in front, with the engine hitting the limiter.",
#:   "V1's driver relied, reasonably in our view, upon two facts. V2 had stopped at the bar, and V2 had remained there while V1 covered some two hundred feet in plain sight. With V1 at thirty feet V2's throttle was opened completely. V2 entered the path of V1 with its drive wheels slipping, and the contact was between V1's bumper and V2's rear door.",
#:   "When we were children we did play \"Ochs am Berg\", you must stand like a statue and when the other is not prepared, you run. This motorcyclist plays it still. He stands at his white line, very correct, one shoe down. I come, I come, he's a statue; I'm almost by him, and he runs, with full gas, directly before my wheel.",
#:   "They expected nothing of the lorry. It had drawn up where the by-road ended, on its line, and had let the whole afternoon go by upon the highway, as cattle will. They were abreast of the last tree when it ceased to be cattle. It bellowed and came out at them, or rather out before them, straining with all it had, and nothing but the ditch was left.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["hesitate", "accelerate"]
#: position = "crossing"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 45.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it accelerates"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it comes to the line"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_DISTANCE = Range(12, 45)
param OPT_ADV_SPEED = Range(5, 9)
param OPT_THROTTLE = Range(0.5, 1)

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until self.pose[3] > 1 and distanceLeft(advTrajectory, self, advTrajectory.entry) < 1.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until self.pose[3] < 0.05
    do Halt() for 0.4 seconds
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, 10)
