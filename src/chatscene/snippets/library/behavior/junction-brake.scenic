#: description = "The car enters the intersection and suddenly brakes."
#: rephrasings = [
#:   "A vehicle drives into the junction and slams on the brakes.",
#:   "The adversary decelerates hard in the middle of the crossroads.",
#:   "The other driver brakes without warning when the ego expects it to go.",
#:   "The approaching car performs an emergency stop inside the intersection.",
#:   "Instead of clearing the junction, the car loses speed abruptly.",
#:   "he's nearly through and then he slams the anchors on",
#:   "Vehicle 2 entered the intersection and decelerated rapidly.",
#:   "hard braking inside crossing, no reason visible",
#:   "the car coming over the crossroads jumped on the anchors when he was already in it",
#:   "The truck had entered the intersection when its driver braked abruptly for no apparent cause.",
#:   "MC in jct: sharp brk midway.",
#:   "Once inside the junction area, the target applies an emergency braking.",
#:   "The bus goes inside the crossing and there he brakes suddenly.",
#:   "NPC: nominal approach, hard decel trigger as soon as it's past the junction entry line.",
#:   "The van was no sooner over the line and into the crossing than its nose dipped and the tyres squealed.",
#:   "He's in the junction and what does he do? Stamps on the middle pedal. Never brake in there without a reason.",
#:   "car got into the intersection n just braked for zero reason",
#:   "There were squeals of rubber as a coach driver braked midway over the crossroads",
#:   "You were already over the line and in the junction, were you not, when you chose to brake so fiercely?",
#:   "Inside the junction itself that fellow is applying sudden brake, who does like that",
#:   "He's in the box, road's clear, and he goes and stabs the brakes on, heart in my mouth",
#:   "Unexpected hard deceleration of crossing traffic inside the intersection",
#:   "Motorcycle brake-stomps IN the intersection",
#:   "The lorry nosedived on its brakes amid the crossroads.",
#:   "Cab rolls onto the crossroads, next second all four wheels are locked.",
#:   "Into the junction, then bang, full anchors. Nobody knew why.",
#:   "Have the lorry emergency-brake once it's inside the intersection.",
#:   "The coach was inside the crossing already, and there it braked so strong!",
#:   "Crossing bike chops its speed savagely mid-intersection.",
#:   "We expected the hatchback to carry on through the crossroads, but the moment it was in, its tail lifted and its speed simply collapsed.",
#:   "Set up a side-road saloon which drives into the intersection at normal pace and there, without any cue, demands maximum deceleration.",
#:   "The other motorist proceeded past the give-way line and, having got inside the junction, applied his brakes with great violence for no cause I could see.",
#:   "Halfway through his paper round the boy saw a van sail onto the crossing and then practically stand on its nose.",
#:   "If you watch the SUV, it's committed, it's in the box, and only then does the driver panic and hit the pedal as hard as she can.",
#:   "V2 passed the intersection entry at 45 km/h; skid marks beginning in the centre of the conflict zone show an abrupt application of the brakes.",
#:   "I had judged that he'd be over and away before I got there. Then his brake lights blazed in the very middle of the crossroads and all that speed was gone, and my judgement wasn't worth a penny.",
#:   "From the cab of my wagon I could see the whole junction. The little Peugeot came in from the side street quite sensibly, and once its wheels were over the line she must have seen a ghost, because she stamped on the brake for all she was worth.",
#:   "The purpose of this case is to check prediction. The agent approaches the intersection, enters it as if it would pass straight through, and then commands a sudden strong deceleration inside it, invalidating the constant-velocity assumption at the worst moment.",
#:   "I told the officer that the motorcyclist had only himself to blame. Nobody had forced him into the crossing, and nobody made him grab a fistful of front brake when he was there, with the tyre howling and the back wheel in the air.",
#:   "Lesson of the day: never trust that a bus which is going will go on going. It drove into the intersection in a nice steady way, and then some passenger must have shouted, for the driver threw out the anchors right there.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["brake"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 6.0
#: high = 11.0
#: unit = "m/s"
#: meaning = "how fast it approaches"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.4
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_BRAKE_DISTANCE"
#: low = 0.0
#: high = 8.0
#: unit = "m"
#: meaning = "how far before the place where their ways meet it brakes"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_SPEED = Range(6, 11)
param OPT_BRAKE = Range(0.4, 1)
param OPT_BRAKE_DISTANCE = Range(0, 8)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < globalParameters.OPT_BRAKE_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
