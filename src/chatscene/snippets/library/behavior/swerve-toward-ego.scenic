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
#:   "Neighbouring truck gave a lunge our way, then got itself straight.",
#:   "Let the bus in the adjacent lane twitch egoward and recover.",
#:   "He came over at me for a heartbeat, then held his lane.",
#:   "Moto at side leans suddenly to us, after this goes straight again.",
#:   "Nearly kissed our door, that cab, before it pulled itself together.",
#:   "The lorry running next to us bulged over the dashed line without warning, hung there for a moment and slotted back where it belonged.",
#:   "The adjacent target performs a brief lateral deviation towards the lane of the vehicle under test, whereupon it realigns itself with its own lane.",
#:   "woman in the next lane mustve dropped something bc her car yawed in our direction, a second later she had it pointing forward again",
#:   "V2 departed briefly toward the lane occupied by V1 before its driver steered back and resumed a straight course in the original lane.",
#:   "If that coach beside you sways over like that again, don't retaliate; look, he's woken up, and he's running true in his own lane.",
#:   "Side lane's pickup, he all of a sudden shook towards my car, my heart stopped, then he made his steering straight and continued.",
#:   "I was alongside a furniture van on the ring road when it flinched in my direction, so near that I could have touched the lettering. Just as quickly it was upright and in its proper lane, going along as if nothing had occurred.",
#:   "An agent in the neighbouring lane should produce a scare rather than a collision. It darts laterally at the ego's lane for about a second, then countersteers and goes on in its own lane at its former speed, never really joining ours.",
#:   "Through the side window I watched the motorcyclist look over his shoulder, and as people do, he went where he looked. The bike dipped over towards us; then he caught it, set it upright and rode on parallel to us, shaking his head.",
#:   "Old habits, said the coach driver when they asked him. He'd seen a bag in the road and his hands had done the rest, a quick tug at the wheel toward the car in the next lane and another to put the bus straight.",
#:   "Ever had your life flash by at sixty? The saloon next door made a grab for our lane, mirrors almost touching, and while my passenger was still screaming it had already straightened its wheels and was sailing along on its own side of the dashes.",
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
