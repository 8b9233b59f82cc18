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
