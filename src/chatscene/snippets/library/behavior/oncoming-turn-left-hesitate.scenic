#: description = "The oncoming car starts to turn left across the ego's path, pauses, and then goes on."
#: rephrasings = [
#:   "he starts his left turn, sees us, stops, and then goes anyway",
#:   "Vehicle 2, approaching from the opposite direction, began a left turn, halted momentarily, and completed it.",
#:   "opposing left-turner dithers in the middle, then completes",
#:   "The oncoming target turns left across the path of the VUT with a short standstill in the turn.",
#:   "The car in front of us from the other side turns left but he is not sure, makes a pause and continues.",
#:   "A lorry facing the ego swings left in two goes, with a doubtful halt in between.",
#:   "The biker coming the other way wavers halfway through his left turn.",
#:   "It begins to turn off leftward against the traffic, loses its nerve, and then finishes.",
#:   "she began to turn over in front of me, lost her nerve for a second and then finished it anyway",
#:   "The oncoming vehicle initiated a left turn across V1's path, paused mid-turn, and then completed the turn.",
#:   "Opp. bus: starts L, stops short, then on.",
#:   "The oncoming target begins a left turn across the VUT's path, interrupts it briefly and then completes it.",
#:   "The car from front starts to go left before me, waits a little in the middle, and then goes.",
#:   "LTAP/OD with dwell: turn start, short pause in the conflict zone, resume.",
#:   "The ambulance had begun its turn before them, checked as if in doubt, and then went through with it.",
#:   "He's turning left over you, he's stopped, is he letting you by? No, he's carrying on with it.",
#:   "car from the other way started turning left, froze for a sec, then went anyway",
#:   "An approaching driver began his left turn, wavered in front of traffic, and then completed it",
#:   "You set out upon the left turn, you paused in the path of the claimant, and thereafter you resumed?",
#:   "Opposite car turning left in front of us, then stop to think, then go again, aiyah",
#:   "Starts his left over me, bottles it, has a breather, and then he finishes the job",
#:   "Interrupted left turn of opposing traffic: start, pause, continuation",
#:   "Oncoming ambulance starts a left, FREEZES, then goes",
#:   "The motorbike facing us began to peel left, faltered, and finished.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "Euro NCAP car-to-car front turn across path; own code"
#: [slots]
#: actions = ["oncoming", "turn-left", "hesitate"]
#: position = "oncoming"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 10.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 8.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = -1.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far beyond where their ways meet it pauses"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.4
#: high = 1.0
#: unit = "s"
#: meaning = "how long it pauses"

param OPT_ADV_DISTANCE = Range(10, 30)
param OPT_ADV_SPEED = Range(5, 8)
param OPT_STOP_DISTANCE = Range(-1, 3)
param OPT_STOP_TIME = Range(0.4, 1)

advTurn = "left-turn"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 8.5 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory) until self.pose[3] < 0.05
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
