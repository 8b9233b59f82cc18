#: description = "The oncoming car swerves into the ego's lane, brakes hard, and stops there."
#: rephrasings = [
#:   "he swerves across at us and then stamps on it",
#:   "Vehicle 2 veered across the centreline, braked heavily, and came to rest in the lane of Vehicle 1.",
#:   "opposing veh swerves over, full brake, stands in our lane",
#:   "The oncoming target steers abruptly into the lane of the VUT and brakes to standstill.",
#:   "The truck makes a fast movement to our lane and brakes until it stays.",
#:   "A biker opposite loses it, shoots over the line and slides to a halt.",
#:   "To avoid something on its side, the van flings itself onto ours and skids to a stop.",
#:   "It darts over in front of the ego and pulls up with smoking tyres.",
#:   "The car coming towards me lurched onto my side, jammed on its brakes and ended up stationary in my way.",
#:   "Unit 2 crossed the center line, braked hard, and came to final rest in Unit 1's lane.",
#:   "Truck oncoming, veers over, full brake, stands in our lane.",
#:   "The opposing vehicle deviates into the lane of the test vehicle, performs full braking and remains at rest in it.",
#:   "The car from the front comes in my lane, brakes much and stands there before me.",
#:   "Opp. actor jumps the centreline, hard decel to 0, blocks us head-on.",
#:   "It slewed over to their side, tyres howling, and finished up nose to nose with them.",
#:   "Bus coming the other way's slid over the line, he's locked up, he's stopped smack in your lane.",
#:   "car coming at me jerked into my lane, slammed it n just stopped there facing me",
#:   "An oncoming car careered onto the wrong side, braked fiercely and was left standing in the opposite lane.",
#:   "You left your half of the road, you braked with all your force, and in my client's lane you came to rest.",
#:   "Opposite car came into my lane, sudden brake, and he is standing nose to nose with me.",
#:   "Chucks it over to my side, locks everything up and there he sits, headlamp to headlamp.",
#:   "Lane departure of opposing vehicle with full braking to standstill in own lane",
#:   "HE SWERVED INTO MY LANE AND STOPPED DEAD facing me",
#:   "The oncoming van yaws into our lane and screeches to rest.",
#:   "Oncoming bus lunges into our lane and emergency-brakes to a stand.",
#:   "Lorry opposite jinks over to us, brakes flat out, stays.",
#:   "aproaching van cuts across the centre line then a crash stop",
#:   "WRONG SIDE, FULL STOP: car flies over and halts facing us",
#:   "Opposing scooter: abrupt lateral move into ego lane, panic halt.",
#:   "Simulate an oncoming pickup that is thrown over onto the AV's side of the road and then brakes as hard as it can until it stands there.",
#:   "To miss a dog he yanked the wheel, shot over from the opposite lane into mine and brought the thing to a screaming halt in front of me.",
#:   "The coach approached in its own lane, departed from it toward the VUT with a sudden steering input, decelerated at the limit and stood in the VUT's path.",
#:   "There it stood, smoking, a motorbike that a moment ago had been coming the other way, before it flew across the line and was braked to rest.",
#:   "The truck from the opposite direction has suddenly jumped in our lane, the wheels were blocked, and it stayed planted in front of us.",
#:   "All units, head-on hazard: car from the other direction has come across the line, braked violently and is now stationary in the oncoming driver's lane.",
#:   "I was doing about forty and this lorry was coming the other way, perfectly ordinary. With no warning its cab jerked over to my side of the line. He must have hit the brakes with both feet, as it juddered to a stop right there in my lane.",
#:   "Vehicle 2, travelling in the opposite direction, steered sharply to the left and entered the lane of Vehicle 1. Skid marks of eleven metres establish that it was then braked at the limit of adhesion. Its final position was wholly inside Vehicle 1's lane, facing Vehicle 1.",
#:   "The third variant starts with a well-behaved oncoming minibus. At the trigger it darts sideways until it is in our lane, and it immediately goes onto full brakes, ending at zero speed before our bumper, where it remains. We want a stop, not a bypass at any price.",
#:   "A bee in the helmet, the rider said afterwards. All we saw was a motorcycle coming up the pass, suddenly it veers over to our side, the back wheel locks, smoke, and then he's standing in our lane looking at us through his visor.",
#:   "Granny screamed, because the blue car which had been coming towards us on the other half of the road leapt right over to ours. Its tyres made a horrible noise from braking, and when it was quiet again it was standing still before us, nose first.",
#:   "Opposite car bolts over the line, tyres lock, now faces us, stationary.",
#:   "From the far side a minibus lurched our way and screeched to nought.",
#:   "Oncoming scooter jinked into our lane, anchored up, stayed put.",
#:   "The lorry headed the other way left its own half as if shoved, stood everything on end, and that's where it was, before our grille.",
#:   "Initially in the opposing lane, the target performs a step steer into the ego's lane, decelerates at the friction limit and remains there at rest.",
#:   "Could anyone have avoided a bus that jumps out of the opposite lane into theirs and then skids to a stop dead in front?",
#:   "That Maruti coming from opposite, all of a sudden he cut into my lane, braked so much that smoke came, and there only he stood.",
#:   "Have the motorbike coming towards us fling itself onto our side, haul on both brakes and end up standing in our lane, face to face.",
#:   "He'd swung over to our side to miss a pheasant, the oncoming farmer, and hit the brakes so hard that his truck stood there ticking.",
#:   "It's the angle I shall remember. The hatchback had been coming down to us in its own lane, upright and proper; then it was leaning, its far wheels hardly touching, and it was on our half. I shut my eyes for the noise. When I opened them it had come to a stand, its numberplate a yard from ours.",
#:   "Skid marks begin on the westbound side, cross the centre line at a shallow angle and finish in the eastbound lane. They're as black as boots for the last nine metres. At the end of them stood V2, which had been westbound, facing V1, its operator still gripping the wheel with both feet on the pedal.",
#:   "Tell control the A-road's shut at the dip. A coach bound for Leeds has come across out of its own lane into the one bound for Hull and been stood on its nose there by the driver. It's not going anywhere. First vehicle stopped short by about a bus-length and everybody's fine.",
#:   "The children's version is that the taxi wanted to give us a kiss. It was driving towards us on the other half and suddenly it came over to our half, quick as a frog. It did a scream with its wheels, and then it didn't kiss us, it just stood there looking.",
#:   "Head-on, offset zero, closing speed zero: that's how the clip ends, and you wonder how we got there. Wind it back. The van's in the opposite lane, minding its own business; in half a second it has skipped the line into ours; two black stripes, a puff of rubber smoke, and it's parked on our side.",
#:   "You were expecting him to go past your right elbow, and so was I. Something's given him a start, so he's darted over onto our side and thrown all his brakes on. Well held. He's at a standstill in our lane now, so hazards on and let's see if he's all right.",
#:   "For test case five, the opposing pickup drives normally until the separation falls below the threshold. A violent steering input then brings it into the subject vehicle's lane, where it is decelerated at eighty per cent of maximum. It stops there, and the run is concluded with it blocking that lane.",
#:   "I have a heavy truck and cannot jump away. The motorcycle came against me on its own side; there was gravel or I don't know what. It was thrown over the line to me, the wheel blocked, it whistled terribly. And as I stood also, it stood in my lane, one metre before my radiator.",
#:   "There was no reading what he wanted. He came on down his own side between the poplars, and then the poplars were behind the wrong edge of him, for he had shied across the crown of the road; and there, in their lane, with a long tearing cry of rubber, the bus dug itself in and was still.",
#:   "My claim is for the eggs. I braked for a white estate which, until that moment, had been approaching on its own half of the lane. It shot across to mine, I don't know why, with the driver hauling at everything. By the grace of God it pulled up in time, and in my lane it stayed.",
#:   "What does the AV do when the space ahead, free a second ago, has a bonnet in it, pointing the wrong way and going nowhere? The bonnet belongs to an oncoming SUV. It has veered out of its own lane into ours and been braked flat out to a stand, and that is where we leave it.",
#:   "Opposing bus: over the line, wheels locked, parked facing us.",
#:   "Oncoming Audi hops into our lane, skids, stays put!!",
#:   "From its lane to ours, tyres screaming, and there it stood.",
#:   "The coach that'd been coming the other way now stands, on four smoking black stripes, with its headlamps against ours in our own lane.",
#:   "At zero the pickup is in the opposite lane; at one second it's in ours; at three it's halted there and the air is full of rubber.",
#:   "A scooter, coming against us on the good side, throws itself on the bad one, which is ours, and brakes there until nothing of it moves.",
#:   "He can keep to his own half for a mile, your worship, and then fling himself on to mine, stamp on everything and remain there looking at me?",
#:   "Ensure the opposing lorry leaves its lane by a sharp steer into the ego's, followed by strong deceleration to rest; it must not return.",
#:   "What came over the white line with a jerk and ended, squealing, as a stationary obstacle in our lane had been ordinary oncoming traffic a second before.",
#:   "The dog had run out on his side, he told us afterwards, trembling. We hadn't seen the dog. We'd only seen a van that was minding its business in the lane across from ours be suddenly in ours with its nose on the floor, and we'd seen the nose come up again a few feet from us once it was at rest.",
#:   "Where did I first have him? Over there, officer, beyond the paint, going towards town. Where did I have him last? Here, in my lane, that's his bumper and that's my bumper, you couldn't get a hand in. And the two black lines from there to here, at a slant, are how he did it, with me shouting.",
#:   "I measured it out afterwards in steps. Twelve from the bend to where the motorbike jinked over the middle; that's clear from the scrape. Nine from there, all of them rubber, on my side, to the place where it stopped, upright, with the rider still on. And three from his front wheel to mine. Three's not many.",
#:   "Six chevrons on the centre line, and the coach went over the fourth. Before the fourth I had no cause to look at it, it was coming along properly. After it, I'd a coach in my lane with its wipers on and its wheels off, by which I mean they had ceased turning. It slid, it sagged, and it was done.",
#:   "No one was hurt, and the road was opened again at six. The milk tanker, northbound, had been avoiding a cow. It had leapt from the northbound lane to the other and was there braked so hard that the cab window fell out. A nurse driving south found it stationary before her, with its lights on, and pulled up.",
#:   "That's a nasty one and I'll talk you through it. You're braking already, good. The taxi's come out of the opposite lane into yours in one go, you saw his wheel flick. Don't dive left, because he isn't going back and isn't coming on. Smell that? He's burned off every mile an hour he had, and he's sitting there.",
#:   "The opposing truck's yaw rate spikes to minus twelve degrees per second, and its lateral position goes from plus three and a half to zero, that's to say our lane. Simultaneously the longitudinal distance stops shrinking as fast, and then it stops altogether on our side: the truck is at rest, and so by now is the ego.",
#:   "Every pedestrian in the street turned round for that noise. I got to see what went before. There was a hearse, headed for the cemetery on the left half, and there was the AV on the right half going the other way. A hat blew out; the hearse came over bodily to the right half; and then, the noise; and then a hearse, unmoving.",
#:   "The man drew up his knees, as though that were of any use. For the headlights, which had been keeping so decently to the far lane, had made a lunge, and stood full in the glass. There was a howl; they bowed to the ground; they rose again; and they were merely two headlights, at rest, on his side of the road.",
#:   "Like a horse that sees a snake, this is how the little truck did. It came from Oaxaca, in its lane, I came from the sea, in mine. A horse jumps, so it was in mine. A horse then puts all four feet on the ground and will not walk. There the truck was, with four feet in the ground, at two metres.",
#:   "Collision avoided by 0.8 m; both stationary. Working backwards: V2 had come to rest facing V1, within the lane belonging to V1. Preceding this were nine metres of locked-wheel braking in the same lane. Preceding that was an abrupt steering movement over the centre line. And before it V2 was ordinary opposing traffic, in the lane of its own.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "swerve", "brake", "stop"]
#: position = "oncoming"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 7.0
#: high = 11.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 22.0
#: high = 48.0
#: unit = "m"
#: meaning = "distance to the ego at which it swerves"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 2.2
#: high = 3.8
#: unit = "m"
#: meaning = "how far it swerves"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.6
#: high = 1.2
#: unit = "s"
#: meaning = "how long after it swerved it brakes"

param OPT_ADV_SPEED = Range(7, 11)
param OPT_ADV_DISTANCE = Range(22, 48)
param OPT_SWERVE = Range(2.2, 3.8)
param OPT_STOP_TIME = Range(0.6, 1.2)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until self.pose[3] > 5 and gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do SwerveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE) for globalParameters.OPT_STOP_TIME seconds
    do BrakeOnPath(advTrajectory, 0.8, globalParameters.OPT_SWERVE)
