#: description = "The car enters the intersection, swerves to its left, and stops."
#: rephrasings = [
#:   "comes in, yanks it left and slams to a halt",
#:   "Vehicle 2 veered to its left inside the intersection and came to rest.",
#:   "swerves in crossing, then dead stop",
#:   "The target performs an abrupt steering input to the left in the junction and comes to a standstill.",
#:   "The truck goes suddenly to left side in the crossing and then it stands.",
#:   "A biker dodges aside and pulls up sharp.",
#:   "A van slews off its line and ends up standing askew.",
#:   "It lurches to one side and comes to grief there, motionless.",
#:   "car lurched over to his left halfway through the crossroads and then sat there",
#:   "After entering the intersection, V2 veered sharply left and halted.",
#:   "Van in jct: jerks to own L, then halts.",
#:   "Within the junction, the target makes an abrupt left steering manoeuvre and comes to standstill.",
#:   "The motorcycle comes in the crossing, he pulls to his left side and stays there.",
#:   "Inside the intersection: lateral jerk to the actor's left, then full stop off its own line.",
#:   "The bus was hardly in the crossing before it slewed to its left hand and came to rest askew.",
#:   "He's yanked the wheel over to his left in the middle of the junction and stopped there, what's he dodging?",
#:   "he got into the junction then yanked it to his left n stopped all wonky",
#:   "A van flung itself to its own left inside the crossroads and stood there at an angle",
#:   "Having entered the junction, you wrenched the wheel leftward and came to rest, for what purpose?",
#:   "Inside the junction he suddenly cut to his left hand side and stopped there itself",
#:   "Comes over the crossroads, flings it to his left like he's seen a ghost, and stops",
#:   "Abrupt leftward deviation of crossing traffic in the intersection with subsequent standstill",
#:   "Truck JERKS left mid-intersection and just stops",
#:   "The motorcycle darted to its left in the crossroads and stuck.",
#:   "Once inside the crossroads the cab lunges to its left and halts.",
#:   "Enters junction, hard left-hand jink by coach driver, standstill.",
#:   "He steer brusquely at his left in the intersection and rest there.",
#:   "Have the truck come in, veer to its own left, stop.",
#:   "Motorbike flicks left mid-crossing, and there it stays put.",
#:   "Barely into the intersection, the pickup jolted off course towards its left, as if dodging something, and pulled up where it was.",
#:   "We found the van at rest inside the junction, well left of its line, having been wrenched that way by its driver seconds before.",
#:   "The trajectory of the crossing SUV shows a sharp lateral shift to its left-hand side in the junction, followed by a deceleration to zero.",
#:   "Why would a bus, once past the line, hurl itself to its left and then not move another inch in the middle of the crossing?",
#:   "From my bike I saw the lorry roll into the crossroads, snap leftwards all of a sudden and come to a dead stand there.",
#:   "V2 proceeded into the junction; its operator swung the steering wheel rapidly to the left, after which V2 stopped short within the junction.",
#:   "There was a carrier bag blowing about, perhaps that was it. The little car came into the crossroads quite straight, then it ducked to its left, as a horse shies, and there it sat with its engine running and would not go on or back.",
#:   "The adversary keeps to its route up to the intersection. A few metres before the conflict point it is given a left steering impulse, so that it departs from its line to its own left, and it is then braked to a standstill within the junction.",
#:   "Our driver's head came round and he said a bad word. The minibus opposite had gone into the intersection and veered, to its left as its own driver sat, really sharply, and then it had parked itself in there with its hazard lights off and everybody staring.",
#:   "I'm telling you what I saw from my rig, up high. That motorcyclist rode into the crossing nice and upright, and then he threw the bike over to his left, must've been a pothole, and hauled it up to a stop before he'd got across.",
#:   "Q. When it entered the intersection, was it straight? A. It was. Q. And then? A. Then it darted to its left, her left, I mean the driver's. Q. Did she carry on? A. No, sir, she came to a stop in there.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["swerve", "stop"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 22.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 6.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.5
#: high = 3.0
#: unit = "m"
#: meaning = "how far it swerves to its left"
#: [[parameters]]
#: name = "OPT_SWERVE_DISTANCE"
#: low = 4.0
#: high = 9.0
#: unit = "m"
#: meaning = "how far before the place where their ways meet it swerves"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far beyond where their ways meet it comes to rest"

param OPT_ADV_DISTANCE = Range(0, 22)
param OPT_ADV_SPEED = Range(6, 10)
param OPT_SWERVE = Range(1.5, 3)
param OPT_SWERVE_DISTANCE = Range(4, 9)
param OPT_STOP_DISTANCE = Range(0, 3)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < globalParameters.OPT_SWERVE_DISTANCE + brakingDistance(self)
    do SwerveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory, 1, globalParameters.OPT_SWERVE)
