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
#:   "Scooter goes quiet mid-junction, glides out, becomes an obstacle.",
#:   "HGV loses all pull on the crossing, trundles to nothing.",
#:   "Drive lost inside the box; it freewheeled itself to rest.",
#:   "The timing belt went just as the minicab was over the crossroads; what way it had on it carried it a few lengths, and there she sat.",
#:   "Cut the propulsion of the bus when it is inside the intersection, so that it runs on ever more sluggishly and is left standing there.",
#:   "It was no braking, I swear, the lamps were dark; the lorry in the middle of crossing simply had no more force and became slow until zero.",
#:   "I heard the revs vanish from that Ducati halfway over, and it whispered on a bit, slower, slower, until he had to put his boots down.",
#:   "Unit on scene advises vehicle two suffered a power failure within the intersection, drifted some thirty feet with decreasing speed and is now immobile in it.",
#:   "You can tell he's got no engine, can't you, he's waving his arms and the car is only rolling, and there it's rolled its last, slap in the junction.",
#:   "The insured states that a Renault crossing from her left caused the obstruction. Its engine had evidently failed on the crossing itself, for the driver was turning the key over and over while it ran on without any power. Its pace dwindled to that of a pram, then to nothing, and she was left looking at its door.",
#:   "An electric bus does not cough when it dies. That's what fooled me. It came into the junction humming like they do, then there wasn't a hum any more, and it floated on, and I kept waiting for it to clear. Every yard took it twice as long as the one before. The last one it didn't manage.",
#:   "Dear passenger, your ride was delayed because a truck had a fault. It entered the crossing ahead of your vehicle in the normal way, its drivetrain shut down there, it coasted with gradually falling speed and it came to a rest on the crossing. Your vehicle waited until it could be towed.",
#:   "There was nothing sudden about it. The queue had time to groan. In the middle of the crossroads the old Land Rover had given a bang and a puff of blue smoke, after which its driver merely steered, a passenger in his own car, whilst it lost first its hurry, then its walking pace, and in the end its motion altogether.",
#:   "We log the crossing actor's acceleration from here. Before the fault: slightly positive. After: minus 0.4, about what drag and rolling friction would give you, brake pressure zero. That goes on until speed is zero too, which happens plumb in the middle of the conflict area. It does not restart. The AV must not assume that it will.",
#:   "When your motorbike runs dry it picks the spot, you don't. My brother's picked the crossroads by the town hall. I was in the car coming the other road and watched him: twist, twist, nothing. He was down to a wobble by the fountain, and by the zebra he wasn't moving any more at all.",
#:   "He'd filled up with petrol instead of diesel, the daft apeth, and got as far as the first crossroads. I'm in me wagon at the line. His van comes over, gives two great hiccups and a sigh, and from then on it's just gravity and good will, and there's not much of either on the flat. Stuck in the box.",
#:   "Investigators found the crossing vehicle in the intersection with its gear lever in third and its ignition on. There were no tyre marks. A witness who had been waiting described it as having \"run out of breath\": it had come in at normal speed, lost traction about the centre line, and dwindled to a stop over some twenty metres.",
#:   "Mummy says cars can faint. The lorry that was going over the crossing fainted. It was going brrrrm and then it wasn't going anything, it just rolled like my marble rolls on the carpet, slower and slower until it's not rolling. And then the man got out and kicked it and everybody had to wait.",
#:   "The reason for which I could not go with my green: a little truck full of melons. His motor, he broke down exactly when he was on the crossing. You see his face, he pumps the pedal, nothing comes, the truck continues alone one bit, always less, and finally he stays planted in front of all of us.",
#:   "To reproduce: spawn a saloon on the cross street, give it normal speed, and once it's in the box set throttle to nil and leave the brake alone. You should see it lose speed bit by bit and park itself in the middle. The hazard lights are optional, but the drivers we interveiwed all said they'd expect them.",
#:   "Power gone mid-junction, the van coasts down to nothing.",
#:   "The truck ran out of puff in the crossroads and stood.",
#:   "Bike's motor quit in the box; it freewheeled to rest.",
#:   "You could hear the engine go silent as it came over the crossroads, and see the wheels turn slower and slower until they didn't.",
#:   "was waiting for that bus to finish crossing the junction, instead it went quiet in the middle rolled on a bit out of habit and stuck",
#:   "Model a saloon whose propulsion fails within the intersection, so that it bleeds off its speed gently and ends up motionless there.",
#:   "No skid, no brake lamps: V2 had simply lost drive while crossing and, with its momentum used up, came to rest inside the intersection.",
#:   "Mi moto, the motorbike of my cousin I mean, he died in the middle of the cruce, rolled some metres without force and remained.",
#:   "Control, lorry's conked out on the Cross Street junction, he was on the move when it cut, trickled as far as the centre, blocking it.",
#:   "The reason we all sat through three greens is a fuse that costs nine pence. When it blew, the estate car was halfway over the crossroads at a decent pace. Nothing dramatic followed: no bang, no lights, only a car drifting, more and more tired, past the front of our bus until it had no drift left in it.",
#:   "I judged it wrongly, I own up to that. The pickup from the right would be through, I thought, well before I got there, for that's how it was travelling. What I couldn't have known was that its gearbox had come apart. It got slower with every yard, quietly, like a toy running down, and it ran down exactly in front of me.",
#:   "The hazard lights were put on only afterwards, M'lud, when the coach had ceased to move. For the preceding eight seconds it had been on its way over the intersection with a dead engine, decelerating by friction alone, or near enough; the driver pumped the accelerator, he says, and it was as if there were nothing on the other end.",
#:   "One minute the moped was going rrrr over the crossing and the next it was going nothing. You can see the lad look down between his knees. He keeps his feet on the boards and lets it roll, as you do, hoping, and it rolls a bit, and a bit less, and he has to put a foot out, right there in the box.",
#:   "NPC spec: pass the stop line as usual, throttle input set to zero by the fault injector as the junction is reached, mild retardation, final speed nil within the conflict zone. Hold. We want to see whether the AV recognises from the slackening that the crosser isn't going to make it. A hard stop wouldn't do.",
#:   "Grandma's Fiat had a way of giving up the ghost, and on Sunday it chose the crossroads by the church with all of us in it. \"Oh,\" said Grandma. It got very peaceful. The pedestrians were overtaking us by then, and then a pigeon was, and then we weren't going anywhere and a robotaxi was looking at us.",
#:   "It wasn't a crash stop, please write this down exactly. I'd no reason to brake, the way was clear. There was a clunk, the needle of the revs fell on its peg, my foot had nothing under it. I let my tipper roll as far as it wanted, which was to the very middle of the junction, and no further.",
#:   "From three storeys up it looked like a film being slowed. A delivery van glides into the picture from the left, over the white line, onto the crossing, and all the while each frame has it moved on by less than the last one, till there comes a frame that's the same as the one before. The driver gets out and pushes.",
#:   "In our town when a bus is empty of diesel everybody knows it by the sound, first tuk-tuk then no sound. This one became no sound at the chowk only. Like a boat it was coming, softly softly, in front of my car. I thought it will reach the other side. It did not reach. It took rest in the centre.",
#:   "Where did the momentum go, I asked my pupil, because she's a physics student. The taxi had had enough of it to enter the crossroads, and you could see from its drooping nose that no more was being supplied. Into the tyres and the air, she said, as it petered out in front of us and settled there. Correct. Handbrake.",
#:   "Not until it had been at a standstill in front of us for some time did the Jaguar begin to steam. It had glided in, noiselessly, which is the wrong word for a car like that, and each of us in the tram had thought how politely it was slowing down. It wasn't slowing down; it was dead, and merely hadn't finished.",
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

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) / globalParameters.OPT_BRAKE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
