#: description = "The car enters the intersection, stops, and reverses."
#: rephrasings = [
#:   "A vehicle noses into the junction, halts, and backs up.",
#:   "The adversary rolls in, stands still, then moves backward.",
#:   "The crossing driver thinks better of it and goes into reverse.",
#:   "Having stopped on the crossroads, the car backs out again.",
#:   "The other car pulls in before the ego and then drives backwards.",
#:   "he noses out, sees it's too tight, and backs off",
#:   "Vehicle 2 stopped within the intersection and reversed.",
#:   "The truck enters in the crossing, stands, and goes with the reverse gear back.",
#:   "The daft sod drove out into the crossroads, pulled up, then started going backwards.",
#:   "Unit 2 entered the intersection, halted, and proceeded to back up.",
#:   "Bus in junction, stops, R gear, backs.",
#:   "The target vehicle moves into the conflict area, comes to rest and then travels rearward.",
#:   "Truck goes in the crossing, stands, and drives back again.",
#:   "Actor in box changes its mind: halt, then negative speed to retreat.",
#:   "It had gone out too far, so it stopped in the middle and shrank back the way it had come.",
#:   "He's in the middle of the junction and, hang on, his reversing lights are on, he's coming back.",
#:   "this bus drove into the intersection stopped and then started BACKING UP bro",
#:   "Onlookers gasped as a lorry halted midway over the crossroads and began travelling backwards.",
#:   "So having gone forward into the junction, and having halted there, you elected to go astern?",
#:   "Inside the junction he stopped and took the reverse gear, what is this yaar.",
#:   "Gets himself out in the middle, has a wobble and starts backing out of it, with me right there.",
#:   "Rearward motion of crossing vehicle after stop in the conflict area",
#:   "WHO REVERSES IN THE MIDDLE OF AN INTERSECTION?!",
#:   "The truck halts within the crossing and backpedals.",
#:   "Lorry pulled into the crossroads, stuck there, then rolled back on its reversing beeper",
#:   "The silly car went in the crossing, stopped and drove bum first!",
#:   "Make the van enter the junction, come to rest and retreat in reverse gear.",
#:   "Why drive into an intersection only to halt and back out?",
#:   "Agent into conflict zone, full stop, then astern.",
#:   "The bus driver realised halfway out that he'd never make the bend; he pulled up inside the crossroads and put the thing in reverse.",
#:   "After entering from the side road V2 came to a standstill in the middle of the junction, whereupon its operator selected reverse and moved off rearwards.",
#:   "Our robotaxi must cope when a pickup comes out into the intersection, stands there for half a second and then travels tail first.",
#:   "It was only when her white lamps came on that I understood: the lady had driven in, changed her mind, stopped, and was now coming out backwards.",
#:   "In the middle of crossing the taxi he makes stop, and after this he is going with his back in front, very dangerous.",
#:   "Units be advised, box truck has gone into the intersection, come to a halt, and is now rolling backwards with no banksman.",
#:   "He must have missed a no-entry sign. One moment he was driving into the junction like anybody else, the next he had pulled up right in the middle, and then I heard that whine a gearbox makes and he was moving backwards.",
#:   "For the record, the other party's explanation was that he wished to let a lorry by. To do so he halted his car after having entered the intersection, engaged reverse, and drove several metres backward without, as he admits, looking over his shoulder.",
#:   "The planner treats anything that is inside the junction as leaving it forward. Please add an actor which drives in, brakes down to a complete standstill, dwells briefly and then shows negative longitudinal velocity for a couple of seconds.",
#:   "I've taught people to drive for thirty years, and this one still made me gasp. The estate rolls in, stops dead in the middle as though struck by a thought, and next thing its reversing lights glow and back it goes.",
#:   "The artic's cab had poked well into the crossroads before the man behind the wheel understood that the street was too narrow. The brakes sighed, everything stood still for a breath, and then the whole long contraption began to go back.",
#: ]
#: adversaries = ["car", "truck", "bus"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["stop", "reverse"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -4.0
#: high = 26.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.0
#: high = 8.0
#: unit = "m/s"
#: meaning = "how fast it comes in"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.0
#: high = 4.5
#: unit = "m"
#: meaning = "how far beyond where their ways meet it stops"
#: [[parameters]]
#: name = "OPT_ADV_BACK"
#: low = 1.5
#: high = 4.0
#: unit = "m/s"
#: meaning = "how fast it backs up"
#: [[parameters]]
#: name = "OPT_ADV_BACK_TIME"
#: low = 1.0
#: high = 4.0
#: unit = "s"
#: meaning = "for how long"

param OPT_ADV_DISTANCE = Range(-4, 26)
param OPT_ADV_SPEED = Range(3, 8)
param OPT_STOP_DISTANCE = Range(0, 4.5)
param OPT_ADV_BACK = Range(1.5, 4)
param OPT_ADV_BACK_TIME = Range(1, 4)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory) until self.pose[3] < 0.05
    do Halt() for 0.5 seconds
    do ReverseStraight(globalParameters.OPT_ADV_BACK) for globalParameters.OPT_ADV_BACK_TIME seconds
    do Halt()
