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
#:   "SUV drives up normally, then snatches a right at the final instant.",
#:   "Ordinary speed, no hint, and abruptly it peels off right.",
#:   "Biker, steady approach: cranks it over to the right terribly late.",
#:   "He comes normal, and when it is almost too late he goes right.",
#:   "Right turn? He only decided on it when he was there!",
#:   "The bus had been coming on at the usual town speed, and its front wheels went over to the right only when the corner was upon it.",
#:   "Have the other car approach as if nothing were to happen, and let it begin a sudden turn to its right at the latest possible moment.",
#:   "Up to the junction the pickup held thirty and looked for all the world a through vehicle; then its driver flung it round to the right.",
#:   "An ordinary approach, you'd say, nothing to see, until the scooter rider ducks into the street on his right with no room left to do it.",
#:   "Signal? Not on your life. That lorry arrived at the same rate as everyone and then swung off right when he was practically past the opening.",
#:   "The trajectory is straight at constant speed until shortly before the conflict point, where the yaw angle changes by 90 degrees to the right.",
#:   "My statement is that the taxi neither slowed nor indicated on the way up to the crossroads. I took it that he would go over. When he had as good as reached me he cut his wheel to the right and went off into the other street.",
#:   "This is why I teach you to cover the brake. That coach was doing a perfectly regular speed, no blinker, in a straight line, and at the very mouth of the junction its driver remembered where he was going and heaved it round to the right.",
#:   "We were discussing whether it was a Polo or a Golf when it made us both shut up. It had come along quite calmly, as people do when they're going straight on, and out of that calm it whipped to the right with a squeal, at the point of no return.",
#:   "V2 was travelling at a speed consistent with the surrounding traffic and its path offered no indication of an intended manoeuvre. Immediately before the point of conflict its heading changed abruptly clockwise, and V2 departed to its right. Reaction time for V1 was below one second.",
#:   "Grandad says the man in the van must have a bad sat nav. He drove to the crossing like everyone does and then he must have heard it say right, because he spun the wheel that way so late that the boxes inside went bang.",
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
