#: description = "The car approaches at a normal speed and makes a last-second right turn."
#: rephrasings = [
#:   "A vehicle comes on as if to go straight and abruptly swings to the right.",
#:   "The adversary decides at the final moment to turn right.",
#:   "The other driver yanks the wheel to the right in the middle of the junction.",
#:   "Late and without signalling, the car turns off to its right.",
#:   "The approaching vehicle suddenly hooks right into the road the ego is taking.",
#:   "looks like he's going straight and then he chucks it right at the last second",
#:   "Vehicle 2 initiated an abrupt right turn at the last moment.",
#:   "straight, straight, then sudden right, no indicator",
#:   "he came along at a perfectly normal lick and then hung a right at the very last moment, no warning at all",
#:   "Vehicle 2 approached at an ordinary speed and executed a right turn at the last possible instant.",
#:   "MC normal appr., then late R turn.",
#:   "The target approaches at normal speed; its right turn is initiated only at the latest feasible point.",
#:   "The bus drives normal, I think straight, but in the last moment he turns to the right.",
#:   "Late-decision right-turner: no slowing ahead of time, heading change triggered right at the junction mouth.",
#:   "The truck had come on as though going straight, and only when it was nearly past the corner did it wrench itself right.",
#:   "Doesn't look like he's turning, does it? And yet, blink, off to the right, left it till there was no road left.",
#:   "he was deffo going straight and then nope, random right at the very end",
#:   "A coach everyone assumed was going ahead veered off to the right with no time to spare",
#:   "You gave every impression of continuing, and only at the mouth of the turning did you swing right?",
#:   "Coming straight straight, then last minute only he is taking right, what to do",
#:   "Bike's going straight on, I'd have bet my house, and at the death he ducks off right",
#:   "Late unannounced right turn of approaching vehicle at unreduced speed",
#:   "Truck decides to go RIGHT at the last possible moment",
#:   "The van hooked off rightward at the death.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["turn-right"]
#: maneuver = "left-turn"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it approaches"
#: [[parameters]]
#: name = "OPT_SWERVE_DISTANCE"
#: low = 2.0
#: high = 14.0
#: unit = "m"
#: meaning = "how far before the place where their ways meet it turns"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_SPEED = Range(5, 10)
param OPT_SWERVE_DISTANCE = Range(2, 14)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < globalParameters.OPT_SWERVE_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED, -1.5708)
