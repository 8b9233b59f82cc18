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
#:   "Opposite us a van goes left, sticks halfway, eventually clears our path.",
#:   "Opposite bus half-turns left in our path, waits, resumes.",
#:   "Make the approaching motorbike turn left, freeze briefly, then carry on.",
#:   "In front of the AV the oncoming cab's left turn stalls momentarily, then continues.",
#:   "He set off left over my road, stopped to think, then went.",
#:   "A fire engine facing us swung its nose left through our path, held there as if unsure, and eventually rolled on out of it.",
#:   "The truck against me starts with turning to the left, after two metres it stands, thinks, and then it makes the turn until the end.",
#:   "Left-turning opposing traffic is to stop briefly with its front in the conflict area before clearing it at the original speed.",
#:   "She's turning left over us from the other side, she's had second thoughts, wait for it, and now she's changed her mind again and gone.",
#:   "The left turn took place in two helpings: the saloon coming toward me put its front over, took fright, then finished the manoeuvre.",
#:   "Is he coming or isn't he, this lorry opposite, half into his left and at a stand, ah, now he goes?",
#:   "I was going straight and a hatchback came up on the other side, wishing to go to its left. Out it came; it must have seen me, since it stuck in the mouth of the turn a moment before pushing on over my lane.",
#:   "V2, oncoming, entered a left turn toward Mill Lane. Its driver applied the brakes and paused in front of V1's lane for an estimated two seconds, reportedly to assess V1's distance, whereupon V2 was driven on to complete its turn.",
#:   "Some turners commit, some don't. The motorcyclist meeting us here starts to his left, brakes to a stop with the wheel already over, dithers like a hen, and when you believe he's letting you by, he goes over after all.",
#:   "Negotiation ticket. The ambulance comes opposite, initiates a left through our trajectory, halts for a random dwell of one to three seconds so the planner thinks it yields, and then it does proceed across and away.",
#:   "The bus driver from the opposite side put his indicator and was taking left across my lane. Then he stopped half way, he looked at me, I looked at him, and only afterwards he completed his turning.",
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
