#: description = "The oncoming car turns left across the ego's path, stops, and reverses."
#: rephrasings = [
#:   "he swings left in front of us, panics, and backs off again",
#:   "Vehicle 2 initiated a left turn from the opposite direction, stopped, and backed up.",
#:   "opposing left turn aborted, halts, reverses",
#:   "The oncoming target turns left into the path of the VUT, comes to a standstill and moves rearwards.",
#:   "The truck from the contrary direction turns left, then it stops and goes back in reverse.",
#:   "A bus facing us thinks better of its left turn and retreats.",
#:   "The van coming the other way breaks off its left turn and rolls backwards.",
#:   "Halfway through turning off to its left, it gives up and withdraws.",
#:   "He started his left turn over my path, bottled it, stopped and then backed up.",
#:   "Opposing Unit 2 began a left turn across Unit 1's path, stopped mid-turn and backed up.",
#:   "Opp. truck L-turn across ego, halts, reverses out.",
#:   "The oncoming target starts a left turn through the VUT's path, comes to rest and then moves rearward.",
#:   "The bus from the front turns left before me, stands, and drives again backwards.",
#:   "Oncoming left-turner aborts mid-turn: stop, then reverse gear back the way it came.",
#:   "He'd swung halfway across her, lost his nerve, stood there a moment and then scrambled backwards.",
#:   "He's turning across you, no, he's stopped, and now he's going back on himself, wait for him to sort it out.",
#:   "he started turning left in front of us, panicked, stopped and went backwards lol",
#:   "The approaching coach abandoned its left turn half done and retreated in reverse.",
#:   "You commenced a left turn before the oncoming plaintiff, you halted, and you then retreated backwards?",
#:   "Opposite lorry started to turn left in my path, then stopped and gostan back.",
#:   "Starts his left across me, gets cold feet, sits there, then out comes the reverse.",
#:   "Abandoned left turn of opposing vehicle with rearward withdrawal from ego path.",
#:   "STARTS LEFT TURN, CHICKENS OUT, REVERSES",
#:   "The oncoming truck bit off a left turn, halted and recoiled.",
#:   "Oncoming coach angles left over our path, halts, backs away.",
#:   "Facing SUV: left across ego, full stop, withdraws in reverse.",
#:   "It wants left through my way, stands still, then drives backward.",
#:   "Left he came, before us; stopped; and went astern.",
#:   "Let an opposing lorry cut left over us, cease, and reverse.",
#:   "The cab from the opposite direction pulled left across the nose of the AV, came to a stand and then, beeping, backed out of it again.",
#:   "A pickup that had been coming to meet us started off to its left right through our lane, stopped as though stung and went into reverse.",
#:   "Driver of V2 stated that he began turning left ahead of oncoming V1, realised his mistake, stopped his vehicle and put it into reverse gear.",
#:   "The big bus facing us hung a left into our road space, got stuck with its own doubts, and returned stern first to where it started.",
#:   "Look at that for manners: van opposite turns left before you, sees you, stops, and reverses so as to let you by.",
#:   "From straight ahead, a left turn which takes it over the ego's route; there it pauses at zero speed and retracts on the same arc backwards.",
#:   "I was heading up the high street and a removals lorry was coming down it. He swung left in front of me for the station yard, but the gate was shut, so there he stood across me. In the end he put it in reverse and drew it back.",
#:   "The opposing target awaits the VUT's approach, then follows a left-turn path that intersects the VUT's lane. It is stopped by moderate braking at the conflict point, stands for half a second, and is thereafter driven rearwards for the specified time, where it remains.",
#:   "Your Honour, the other car approached from ahead of me. It turned to its left, which put it in my path, and I braked. It then stopped, and I waited. The white lamps at the back came on, and it travelled backwards, and only then could I go on.",
#:   "Like a bear that has put its paw in the wrong hive, the huge truck which had been coming at them bent its snout left across their lane, stopped dead, and after a moment's reflection began to draw the whole of itself backwards out of it.",
#:   "pro tip if someone facing u goes left across ur bows and then just freezes, don't scoot round him. mine froze and next second the reverse lights were on and he came back the way he'd come, if I'd gone behind him he'd have hit me",
#: ]
#: adversaries = ["car", "truck", "bus"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "turn-left", "stop", "reverse"]
#: position = "oncoming"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 25.0
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
#: low = 5.5
#: high = 8.0
#: unit = "m"
#: meaning = "how far beyond where their ways meet it comes to rest"
#: [[parameters]]
#: name = "OPT_ADV_BACK"
#: low = 1.5
#: high = 3.0
#: unit = "m/s"
#: meaning = "how fast it backs up"
#: [[parameters]]
#: name = "OPT_ADV_BACK_TIME"
#: low = 0.8
#: high = 2.0
#: unit = "s"
#: meaning = "for how long it backs up"

param OPT_ADV_DISTANCE = Range(0, 25)
param OPT_ADV_SPEED = Range(5, 8)
param OPT_STOP_DISTANCE = Range(5.5, 8)
param OPT_ADV_BACK = Range(1.5, 3)
param OPT_ADV_BACK_TIME = Range(0.8, 2)

advTurn = "left-turn"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory) until self.pose[3] < 0.05
    do Halt() for 0.5 seconds
    do ReverseStraight(globalParameters.OPT_ADV_BACK) for globalParameters.OPT_ADV_BACK_TIME seconds
    do Halt()
