#: description = "The car swerves toward the ego's lane and straightens up again."
#: rephrasings = [
#:   "A vehicle beside lurches across the marking and recovers.",
#:   "The adversary veers at the ego for a moment.",
#:   "The neighbouring car jerks sideways into the ego's space, then back.",
#:   "The driver yanks the wheel over and corrects late.",
#:   "The lorry drifts abruptly out of its lane and returns.",
#:   "He nearly sideswipes us and then jerks back.",
#:   "Vehicle 2 drifted abruptly across the lane line and corrected.",
#:   "It pulls the wheel to our side and again back to its own.",
#:   "The car beside me twitched over at me and then straightened itself out.",
#:   "Vehicle 2 veered toward Unit 1's lane and then regained its course.",
#:   "Veh lunges at ego lane, corrects, stays own lane.",
#:   "The target deviates laterally in the direction of the VUT's lane and then resumes its heading.",
#:   "The bus comes a bit in direction of my lane and then goes straight again.",
#:   "Lateral feint: neighbour jerks at us but doesn't change lane, recovers heading.",
#:   "He gave a sudden lurch in her direction, so that she flinched, and then he was steady again.",
#:   "He's had a wobble towards you, that lorry, but he's caught it, he's back in line.",
#:   "car jerked at us for a sec then went back straight, prob on his phone",
#:   "A lorry keeled momentarily in the direction of a passing car before holding its course again.",
#:   "You came toward my client's lane, though not to stay, and at once righted your course?",
#:   "Side lane bus suddenly leaned towards me, then became straight again, thank God.",
#:   "Has a nibble at my lane, then behaves himself again. Awake now, are we?",
#:   "Momentary lateral excursion of vehicle toward ego lane with self-correction.",
#:   "DRIVER NEARLY SIDESWIPES ME THEN CORRECTS",
#:   "The truck feinted at our lane and steadied.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["swerve"]
#: blocker = false
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -8.0
#: high = 24.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.5
#: high = 2.6
#: unit = "m"
#: meaning = "how far it swerves"
#: [[parameters]]
#: name = "OPT_SWERVE_TIME"
#: low = 1.2
#: high = 1.8
#: unit = "s"
#: meaning = "for how long"

param OPT_ADV_DISTANCE = Range(-8, 24)
param OPT_ADV_SPEED = Range(5, 9)
param OPT_SWERVE = Range(1.5, 2.6)
param OPT_SWERVE_TIME = Range(1.2, 1.8)

behavior AdvBehavior():
    others = [other for other in simulation().objects if other.body is not self.body and other.body is not ego.body]
    # At the latest where it would pass somebody else.
    do KeepStation(advLane, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE or any(0 < headway(advLane, self, other) < 32 for other in others)
    do SwerveOnPath(advLane, globalParameters.OPT_ADV_SPEED, -globalParameters.OPT_SWERVE if offsetFrom(ownLane(egoRoute), self) > 0 else globalParameters.OPT_SWERVE) for globalParameters.OPT_SWERVE_TIME seconds
    do DrivePath(advLane, globalParameters.OPT_ADV_SPEED)
