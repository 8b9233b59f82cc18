#: description = "The pedestrian steps out, suddenly stops, and then walks on diagonally."
#: rephrasings = [
#:   "A person enters the carriageway, halts, and goes on at a slant.",
#:   "The pedestrian freezes short of the lane and afterwards cuts across it obliquely.",
#:   "Someone pauses on the road, then sets off at an angle along it.",
#:   "The walker comes to a standstill and continues in a diagonal line.",
#:   "After a sudden stop the adversary drifts slantwise over the lane.",
#:   "He steps off, stops dead, and then wanders over at an angle.",
#:   "The pedestrian halted after entering the roadway and then proceeded obliquely across the lane.",
#:   "ped out, halt, then slanted path",
#:   "She stepped off the pavement, froze, and then wandered off across at a slant.",
#:   "Pedestrian entered the roadway, halted abruptly, then continued at an angle.",
#:   "Ped steps out, sudden halt, then oblique course.",
#:   "The pedestrian target enters the lane, stops abruptly and resumes on a trajectory oblique to the lane.",
#:   "Man comes on street, stops suddenly and then goes on not straight, in the oblique.",
#:   "Crosser: step-out, hard stop, restart with heading skewed along the road.",
#:   "He came out, pulled himself up short, and when he set off again it was on a long slanting line down the road.",
#:   "Lady's stepped out, she's stopped, now she's off again but cutting the corner, going at an angle.",
#:   "she stepped out, stopped all of a sudden, then kept going but like at an angle",
#:   "A woman stepped into the road, pulled up short and then resumed on a slanting course.",
#:   "He entered, he halted abruptly, and when he resumed it was not straight over but aslant.",
#:   "Came on the road, stood suddenly, then went cross-wise in slanting direction.",
#:   "Steps off, stops as if she's left the gas on, then drifts over on the skew.",
#:   "Pedestrian entry with sudden halt and continuation on oblique trajectory",
#:   "STEPS OUT, HALTS, THEN CUTS THE ANGLE",
#:   "The man emerges, halts and then slants away over the road.",
#:   "Walks out, stops dead, carries on at a slant.",
#:   "Man enters the road, freezes, then wanders obliquely over the lane.",
#:   "Let a jogger step out, abruptly halt, then proceed cornerwise.",
#:   "Off the kerb, sudden standstill, away again on a skewed line.",
#:   "She set foot in the road, checked herself, and then slanted across.",
#:   "The old lady left the pavement, came to an abrupt stop as though somebody had called her, and resumed in a diagonal direction.",
#:   "The person goes on the street, suddenly he is standing like frozen, and after that he walks further, but in a slope line.",
#:   "A pedestrian shall enter, make one unexpected halt, dwell, and continue with the heading rotated so that the remaining path runs obliquely.",
#:   "Watch him: he's out, he's stopped short, and now he's moving off again, only on the skew instead of straight over.",
#:   "Why did the boy come out, pull up all of a sudden, and then keep going kind of sideways up the road?",
#:   "The last leg was slantwise: it came after he'd stepped into the carriageway and stood stock-still there for a second.",
#:   "A woman with a pram pushed off the kerb ahead of us. She stopped in an instant, I suppose because of a dropped dummy, and then set out once more, this time bearing away at an angle rather than going square across.",
#:   "The pedestrian stepped from between two parked cars into the roadway and came to a sudden stop. When he began walking again his direction of travel had changed, being approximately forty degrees from the perpendicular, toward the bus stop.",
#:   "Two things fool the tracker here. First the walker quits moving without warning just after stepping out, and we assume a yield. Then she's off again on a heading that isn't the one she arrived with, but cuts the lane diagonally.",
#:   "He got off the pavement with his nose in his telephone. Something on it made him stop as if he'd hit glass; when his legs began again they bore him slantwise, along and over the street together, still reading.",
#:   "My grandson, he is four, let go of my hand and was out on the road. There he stopped, quite suddenly, to look at the car, and then trotted on crookedly, slanting off in the direction of the swings.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["hesitate", "stop", "diagonal"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.2
#: high = 4.0
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 24.0
#: high = 56.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_ADV_ANGLE"
#: low = 0.45
#: high = 1.0
#: unit = "rad"
#: meaning = "how far its slanted way turns from straight across"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 1.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far from the ego's line it stops"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.5
#: high = 1.5
#: unit = "s"
#: meaning = "how long it stands"

param OPT_ADV_SPEED = Range(1.2, 4)
param OPT_ADV_DISTANCE = Range(24, 56)
param OPT_ADV_ANGLE = Range(0.45, 1)
param OPT_STOP_DISTANCE = Range(1, 3)
param OPT_STOP_TIME = Range(0.5, 1.5)

behavior AdvBehavior():
    # Earlier where it has farther to go, and briskly where the ego would be gone otherwise.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(5) until abs(offsetFrom(egoRoute, self)) < max(2.5, globalParameters.OPT_ADV_SPEED * headway(egoRoute, ego, self) / 8)
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt() until self.pose[3] < 0.1
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    # Slanted along the ego's direction, from whichever side it comes.
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE if offsetFrom(egoRoute, self) > 0 else -globalParameters.OPT_ADV_ANGLE)
