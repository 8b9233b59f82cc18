#: description = "The crossing car runs the red light and turns left at walking pace."
#: rephrasings = [
#:   "he's got red but he just crawls round to the left in front of us",
#:   "Vehicle 2 made a slow left turn against a red signal.",
#:   "left on red, crawling",
#:   "The target turns left on red at a speed below 14 km/h.",
#:   "A bike turns slowly to the left also when the traffic light shows red.",
#:   "A scooter trundles left through the red, unhurried.",
#:   "Against the lights a car eases itself round to its left, holding everybody up.",
#:   "The cyclist ignores the signal and bends left at a snail's pace.",
#:   "He went through on red and then sort of oozed round to the left at a snail's pace.",
#:   "Cross vehicle disregarded the signal and made a left turn at a very low rate of speed.",
#:   "Bike over red, L turn, crawling.",
#:   "The crossing vehicle passes the red signal and performs its left turn at approximately 5 km/h.",
#:   "The motorbike ignores red and turns left very very slow.",
#:   "Red runner turning left at creep speed, long occupancy of our path.",
#:   "The light was against the cyclist, but he crept out anyway and made his leisurely way round to the left.",
#:   "He's come out on a red, he's going left, and you'd think he had all the time in the world.",
#:   "went thru the red and turned left at like snail mode",
#:   "A motorist ignored the red signal and eased round to the left at little more than walking speed.",
#:   "You disregarded the red, and then turned left with such tardiness that no one could get by.",
#:   "Red light also he is not stopping, and turning left slow slow like morning walk.",
#:   "Jumps the red, right, so you'd think he's in a rush, but no, he crawls round to the left like a milk float.",
#:   "Red-signal violation with slow left turn of crossing vehicle and long exposure in conflict area",
#:   "RUNS THE RED... IN SLOW MOTION (left turn)",
#:   "The crossing cyclist slights the red and meanders left.",
#: ]
#: adversaries = ["car", "motorcycle", "bicycle"]
#: requires = ["advMeeting", "advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "turn-left", "slow"]
#: control = "signal"
#: position = "crossing"
#: side = "right"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 15.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 2.3
#: high = 3.5
#: unit = "m/s"
#: meaning = "how fast it turns"

param OPT_ADV_DISTANCE = Range(0, 15)
param OPT_SLOW_SPEED = Range(2.3, 3.5)

advTurn = "left-turn"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_SLOW_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED)
