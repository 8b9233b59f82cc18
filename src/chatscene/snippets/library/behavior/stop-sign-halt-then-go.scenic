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

advTurn = "straight"

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until self.pose[3] > 1 and distanceLeft(advTrajectory, self, advTrajectory.entry) < 1.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until self.pose[3] < 0.05
    do Halt() for 0.4 seconds
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, 10)
