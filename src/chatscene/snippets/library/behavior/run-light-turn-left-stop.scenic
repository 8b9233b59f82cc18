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
#:   "Crossing taxi violates red, starts round to its left, gets stuck there.",
#:   "Through a red, leftward bend begun, coach comes to rest within it.",
#:   "He don't respect red, he turn on left and in the curve he stop.",
#:   "Motorcycle from side street: jumps red, lefts, stands mid-arc.",
#:   "Please: cross vehicle, red ignored, left turn begun, halted halfway.",
#:   "The van stood with its nose pointing halfway between two streets, having driven out of the side road on red and given up its left turn.",
#:   "An SUV that ought to have been waiting at its red swung out to the left ahead of the robotaxi and, half round, went no farther.",
#:   "Crossing artic, red against him, pulls round left as far as the cab will go, then the whole lot stops in the bend and blocks it.",
#:   "The defendant's motor scooter passed the red signal, was steered into a left-hand turn, and was stationary before that turn had been completed.",
#:   "With the stop signal still burning, a bus came from the side and bent to its left, and in the bend its wheels ceased to turn.",
#:   "After violating red, the crossing vehicle negotiates only part of a left turn: it decelerates and dwells on the turning arc inside the conflict zone.",
#:   "We were the first at the green. From the right a cab shot its red light and turned, to its left, so I expected to see it off down the road ahead. It wasn't to be: in mid-turn it halted, and the passenger and I looked at each other.",
#:   "The incident involved a removals truck on the intersecting street. Facing a red light, its driver nevertheless came on into the junction and began to turn left. Before the truck was straight again it had been brought to a stop, and it was standing diagonally over two lanes.",
#:   "Examiner's note: the candidate dealt calmly with a motorcyclist who, from the crossing road, went over the line on red, leant into a left turn, and then, because something was in his way or he'd stalled, pulled up with his machine still leaning halfway round.",
#:   "A lamp is red, a man is late, and the rest follows. He drove out past it, he laid the wheel over to the left, and in the very waist of the turn he saw what he was doing and stopped, and nothing in the world would make him finish it.",
#:   "anyone else had this at the Kirkgate lights? pickup comes out of the side on a solid red, goes to turn left, i mean he's properly into it, and then he's stopped. not after the turn, IN the turn. sat there like a lemon while we all went amber",
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
