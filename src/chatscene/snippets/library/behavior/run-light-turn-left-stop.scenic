#: description = "The crossing car runs the red light, turns left, and stops in the turn."
#: rephrasings = [
#:   "left turn on red and then he just parks it in the middle of the thing",
#:   "Vehicle 2 turned left on a red signal and came to rest before completing the turn.",
#:   "left on red, stops mid-turn",
#:   "The target turns left against the red signal and halts within the junction.",
#:   "The bus makes left turn with red and then it stands in the middle of his turn.",
#:   "A lorry jumps the lights, swings to the left and gets no further.",
#:   "The biker cuts left on red and freezes halfway round.",
#:   "Having ignored the signal, the van bends left and comes to a halt.",
#:   "He ran the red going left and then conked to a halt halfway round the bend.",
#:   "Unit 2 ran the red light, initiated a left turn and came to a stop partway through it.",
#:   "Red, L-turn, stops mid-turn. Stays.",
#:   "The crossing target passes the red signal, begins a left turn and comes to rest before completing it.",
#:   "The car goes with red, turns left and in the middle of the turn he stands.",
#:   "Left-turning red-light violator that freezes in mid-turn and blocks the box.",
#:   "He came through on red, began to swing left, and there, half round, he stuck.",
#:   "He's gone on red, turning left, and now he's stopped halfway through it, you're blocked.",
#:   "turned left on red and then just stopped halfway thru the turn like an npc",
#:   "After ignoring the signal the lorry got midway round its left turn and came to a standstill.",
#:   "You went left against the red, and you did not finish; you came to rest in the midst of the turn?",
#:   "Red light he turned left, then half turn only he stopped there, blocking.",
#:   "Left on the red, if you please, and then he gives up halfway round and sits there.",
#:   "Unfinished left turn on red with stationary vehicle in intersection.",
#:   "TURNS LEFT ON RED THEN JUST STOPS MID TURN",
#:   "The crossing car stole a left on red and stalled in the arc.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "turn-left", "stop"]
#: control = "signal"
#: position = "crossing"
#: side = "right"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 22.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 8.0
#: unit = "m/s"
#: meaning = "how fast it turns"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 4.0
#: high = 8.0
#: unit = "m"
#: meaning = "how far beyond where their ways meet it comes to rest"

param OPT_ADV_DISTANCE = Range(0, 22)
param OPT_ADV_SPEED = Range(5, 8)
param OPT_STOP_DISTANCE = Range(4, 8)

advTurn = "left-turn"

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory)
