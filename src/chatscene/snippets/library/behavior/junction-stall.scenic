#: description = "The car loses its drive in the intersection and rolls slowly to a stop."
#: rephrasings = [
#:   "his engine conks out halfway across and he just rolls to a halt",
#:   "Vehicle 2 lost power while crossing and coasted to rest in the intersection.",
#:   "stalls mid-crossing, coasts out, stands",
#:   "The target decelerates gently without braking inside the junction until it is stationary.",
#:   "The bus has a problem with motor in the middle of the crossing, it becomes slow and then stands.",
#:   "A scooter splutters and dies on the crossroads.",
#:   "The old lorry runs out of puff half the way over and breaks down.",
#:   "Its speed bleeds away little by little until it is stranded in the junction.",
#:   "the old Transit conked out halfway over the crossroads and just coasted to a halt",
#:   "V2 lost power while in the intersection, slowed gradually, and became disabled there.",
#:   "Bus: engine dies mid-jct, rolls out, stands.",
#:   "In the junction the target loses propulsion, coasts down and comes to rest.",
#:   "The motor of the car goes off in the crossing, the car rolls some metres and stays.",
#:   "Simulate a breakdown in the intersection: throttle cut, slow roll-out, no brake, end at v=0.",
#:   "The lorry coughed, lost heart in the middle of the crossing, and rolled ever more slowly until it rolled no more.",
#:   "He's stalled it, poor lad, he's got no drive and it's just trickling to a standstill in the middle there.",
#:   "his car literally died in the middle of the crossroads and just kinda rolled n stopped",
#:   "An elderly bus gave up the ghost halfway over the junction, trickling to a stand",
#:   "The engine had ceased, the vehicle ran on a little under its own momentum and then stood in the junction, correct?",
#:   "Engine gone off in the middle of junction, lorry slowly slowly rolling and then khatam, standing there",
#:   "His motor's packed in right in the middle, he's freewheeling, freewheeling, and now he's a bollard",
#:   "Loss of propulsion of crossing traffic inside the intersection, coast-down to rest",
#:   "Motorbike's engine DIES mid-intersection, slowly rolls to a stop",
#:   "The old van expired in the crossroads and dribbled to rest.",
#:   "Power gone mid-crossroads, it drifted slower, slower, and stood.",
#:   "Moped's motor died in the junction; it rolled itself out.",
#:   "Coach: propulsion lost inside intersection, momentum spent, immobile.",
#:   "Has that saloon just lost its engine halfway across and petered out?",
#:   "Make the HGV's motor fail in the junction and let it run down.",
#:   "It was sitting dead among the traffic signals, having freewheeled the last few yards with no engine, according to the crew of the recovery lorry.",
#:   "I want the hatchback to come into the intersection normally, then its drive fails, and it loses pace bit by bit until it stands.",
#:   "In the midst of the crossing the engine from the motorcycle became silent, and it has rolled out until it stood there.",
#:   "V2's operator reported that all the dash lights came on in the intersection, the throttle went dead, and the truck drifted to rest.",
#:   "The bus was going across and then it got tired and went slower and slower and then it couldn't go any more, right in the middle.",
#:   "Clutch cable snapped, I bet: halfway through the lights he's lost all pull, he's rolling on nothing, and there, he's stuck on the yellow box.",
#:   "I'd just started over when I noticed the pickup crossing from the right wasn't making any noise. No engine, no nothing, just tyres. It was ghosting along on what speed it had left, less and less, and that ran out plum in the middle of the junction.",
#:   "What is being tested is a fault, not a braking event. After entry to the intersection the torque of the crossing target is set to zero; rolling resistance alone lets its velocity decay; the target reaches standstill inside the conflict area and remains disabled.",
#:   "Poor old Albert. His Morris had never let him down in fifty years, but that morning, between the bank and the chemist's where the two roads meet, her heart gave out. She glided on for a bit in silence, ever more gently, and then she was still.",
#:   "Diesel bug, the mechanic said afterwards. All we could tell was that the artic was halfway over the crossroads and there was nothing driving it any more. It trundled on, losing way all the while, and gave out with its trailer across everybody.",
#:   "The robotaxi had the right of way and would have gone, only the van in the crossing was clearly in trouble, hazards on, bonnet smoking. Its motor had cut out there, so it rolled more and more feebly until it had no roll left in it.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["slow", "stop"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 10.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.5
#: high = 7.0
#: unit = "m/s"
#: meaning = "how fast it comes in"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.08
#: high = 0.15
#: unit = "1"
#: meaning = "how fast it loses its way"

param OPT_ADV_DISTANCE = Range(10, 30)
param OPT_ADV_SPEED = Range(4.5, 7)
param OPT_BRAKE = Range(0.08, 0.15)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) / globalParameters.OPT_BRAKE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
