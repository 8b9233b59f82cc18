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
