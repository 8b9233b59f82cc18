#: description = "The parked car backs out of its parking space into the ego's lane."
#: rephrasings = [
#:   "The parked car backs out right in front of us.",
#:   "Vehicle 2 was backing from a parking space into the travel lane.",
#:   "Parked veh reverses out into lane.",
#:   "The target moves rearward out of the parking strip into the path of the VUT.",
#:   "It goes backwards out of the parking and doesn't see us.",
#:   "A delivery van's tail swings out of the bay at us.",
#:   "The lorry shunts off the roadside in reverse, rear first into our lane.",
#:   "Someone shifts to R and rolls out of his spot before our bonnet.",
#:   "Someone came backing out of a bay straight into me, didn't even look round.",
#:   "Unit 2 was backing from a parking stall and entered the travel lane occupied by Unit 1.",
#:   "Parked van, R gear, tail into our lane.",
#:   "The parked target leaves its space rearward, its tail entering the lane of the test vehicle.",
#:   "Car comes out from the parking with its back first, into my street.",
#:   "Stationary actor at the edge moves out tail-first; white lights on, only negative speed.",
#:   "The boot of the thing came sliding out of the row of parked cars into their way.",
#:   "Truck's backing out of that space, he can't see you, give him the horn.",
#:   "some lady backed out of her spot right into my lane w/o looking",
#:   "A pickup came tail-first out of its bay and into the path of moving traffic.",
#:   "You emerged rearwards from the parking place, madam, and so into the lane where my client was driving.",
#:   "Car parked at side took reverse straight into my lane, not even seeing the mirror.",
#:   "Bum first out of the parking spot, straight into my lane, eyes in the back of his head, has he?",
#:   "Tail-first emergence of parked vehicle from its bay into own lane",
#:   "BACKS OUT BLIND from parking spot",
#:   "The parked van butts out rear first.",
#:   "Van emerges boot first from its parking bay, into our way.",
#:   "Parked pickup backs off the roadside and plugs my lane.",
#:   "Let a parked ambulance reverse out in front of the ego.",
#:   "Reversing lights on, out of the space, right across me.",
#:   "Daddy, that parked car is coming out with its bottom first!",
#:   "Nobody was visible at the wheel, yet the parked estate crept backward from its slot between two others until its rear end lay in our lane.",
#:   "A vehicle stationary in a roadside bay engages reverse and steers its rear into the lane of the approaching test vehicle, where it ends up.",
#:   "If you see white lamps in a row of parked cars, cover the brake. Look, that SUV is coming out to you stern first this very moment.",
#:   "The front of my car hit the tail-lift of a lorry because its driver was reversing from the place where he had been parked into the carriageway.",
#:   "The taxi was staying in the parking and he made marche arrière without regarding, so his back part arrived in my lane just before me.",
#:   "Fire engine that had been parked up by the shops is now backing itself off the kerb and into live traffic, can someone get a banksman there?",
#:   "I'd only popped out for milk, Officer. A big four-by-four in one of those slanting bays began to back up, and I hooted, but on it came till the whole rear half stuck out in the lane I was using and I was up against its spare wheel.",
#:   "Observation by the perception team: parked car detected as static clutter, class \"parked\", until its motion flips sign. It leaves its bay backwards and ends with its rear inside the ego lane, blocking us. Tracker took 0.8 s to accept negative speed. Please re-run with the longer box truck as well.",
#:   "Vehicle 2 had been parked at the eastern kerb. Its driver, intending to depart and being unable to go forward on account of a skip, selected reverse and moved out in that direction, so that the trunk entered the lane in which Vehicle 1 was travelling.",
#:   "The trouble with vans is that they've no back window. This one had been parked the entire morning, and then just when I came riding up behind the AV out poked its rear doors, further and further, steering blind into the lane until the AV had nowhere to go.",
#:   "On tonight's episode we ask why anyone would still park nose-in. Exhibit A: a saloon in a roadside space, a driver who can't see a thing, and a rear bumper that comes swinging out backwards into the lane just as our listener arrives there at thirty.",
#:   "Tail of a parked police car slides backwards off the kerb at us.",
#:   "Make the pickup leave its bay in reverse, ending across the ego's lane.",
#:   "WHITE LAMPS, NO EYES: SUV reverses out of its slot into me",
#:   "An ambulance that had been standing at the roadside put its gear the wrong way round and drove its back doors out into the lane we were in.",
#:   "The parked target is moved in reverse, steering its rear end away from the kerb, until it comes to rest obstructing the lane of the VUT.",
#:   "See the little white lights in that row? She's coming out backwards, boot leading, straight into your lane, so stop and let her get on with it.",
#:   "The van stand in parking place, then the driver go back without watch, the van's backside enter my road and I nearly hit.",
#:   "He had not troubled to look over his shoulder before bringing the saloon rearward out of its place and across the half of the road we occupied.",
#:   "Which of you parked nose-in by the chemist's and then backed your four-by-four out of there into the lane under the wheels of a moving lorry?",
#:   "A beeping came from somewhere, but then something's always beeping in this town. My eye was on the pigeons. When I looked up, a tail-lift was emerging from the row of parked vehicles, at knee height, then the doors above it, and it all kept coming until half a lorry was lying across my lane.",
#:   "V2 was unoccupied except for its driver and was parked alongside the curb. The driver shifted to reverse and, without checking, backed out and away from the curb. The rear of V2 passed into the lane in which V1 was travelling and V1 struck its left rear corner.",
#:   "My bicycle was chained to the lamp-post next to that hatchback, so you may imagine I took an interest. The gearbox whined, the front wheels pushed the other way, and it swung its behind out of the space into the road. The robotaxi was on its way along that lane and was left with a rear window to look at.",
#:   "Scenario \"blind back-out\". Start: target parked at the kerb, engine on. At trigger: reverse, moderate speed, lock on, so that the back end travels into the ego's lane. End: it stands there, askew. Acceptance: ego is stationary at least one metre from the tailgate.",
#:   "Dad let me sit in front for once. There was a big fire engine sleeping at the side and then it started beeping and its bottom came out. It came right out onto our bit. Dad went \"whoa whoa whoa\" and we stopped and I could read the numbers on the ladder.",
#:   "I sympathise with people who've been boxed in, I do. The lady had a skip before her and a wall beside her and her only way was backwards. But you send someone out to look, don't you? You do not feed two metres of Volvo, boot first, into a lane with an artic in it and hope.",
#:   "What I saw I saw in the wrong order. First the shattered rear lamp on the road. Then a saloon, stern outward, blocking the lane I'd been driving in, its nose still half inside the parking space. So he must have been reversing out of it as I came by, and he never once turned his head.",
#:   "Officer to control. Delivery van, the flower one, was parked up outside forty-two. He's now come out of the bay the wrong end first and is hanging his tail in the live lane. Traffic's held. He says he thought it was clear; he's got no window in the back.",
#:   "There had been no exhaust, no face, no warning; only the row of parked cars, quiet as books. Now one of the books was being drawn from the shelf. Spine first, the dark estate slid out from between its neighbours and into the lane, and Martin, who had no time for reading, stood on the pedal.",
#:   "At seventy-nine I leave a good distance to parked cars, and this is why. The taxi's front was tight against a wheelie bin. All at once it was going the way a taxi shouldn't, hind end foremost, out from the edge and over my part of the street, and had I been nearer I'd be telling it to St Peter.",
#:   "lol so I'm rolling up the block behind this AV and there's a truck parked, right, backup lights blink, and the dude just commits. Full butt out into the lane. Never stops to check, just keeps scooting rearward till the AV's got bumper for breakfast. It stopped fine tbh.",
#:   "Parked pickup, white lamps, rear end swinging into our lane.",
#:   "Boot coming at us out of the bays. Stern first.",
#:   "ambulance backs off its stand, tail in MY lane, beep beep",
#:   "From between two parked cars came a number plate, a bumper, a rear window with a dog in it, in that order, right over into where we were driving.",
#:   "Please let a lorry leave its roadside space in reverse gear, its rear wheels leading it round into the lane in which the AV is coming up.",
#:   "The reversing bleeper was for the benefit of the cats, I take it, as we were already there when the van's doors swung out from the parking row at us.",
#:   "He couldn't see a thing, poor man. All he could do was put it in R and let the tail go out into the road till somebody hooted, who was me.",
#:   "At trigger distance the target, at rest in the bay, shall be moved rearward with steering applied so that its tail obstructs the test lane.",
#:   "A hatchback which had been asleep nose-in beside the pavement woke up and emerged rump foremost across our way, its driver's face turned anywhere but to us.",
#:   "The strange part is that I never saw her headlights. What I saw was a red lens lit from behind by a white one, then an entire hatchback's hind quarters where the row of parking spaces ended and my lane began. It came out sideways to me, curving. I was on the horn for as long as it took to stop.",
#:   "I'm a traffic warden, so when somebody vacates a bay I look at my watch. It took four seconds. In the first there was the clunk of a gear; in the second the rear tyres were over the edge line; in the third the rear bumper had reached the middle of the near lane, and in the fourth the robotaxi was standing on its nose.",
#:   "We'd been promised a quiet street. Along the kerb sat a line of motors with their faces to the wall of the cinema, and I drove past their behinds, one after the other, at twenty. One of the behinds grew. It grew out of the line, exhaust and all, and had taken half of my lane before I'd found the pedal.",
#:   "Defect report. Object class: parked, velocity zero, confidence high. At range 18 m the object's velocity becomes negative with respect to its own heading, and its yaw changes; it is leaving the parking strip with its back end first. The tail ends up in the ego lane and stays. Our track filter didn't believe it until range 6.",
#:   "My brother the ambulance driver says it's the worst part of his job, not the blood. You come out of the house, somebody has boxed you in at the front, and the only way out of your spot is tail first into whatever's in the road. That evening it was a white test car, and it had good brakes, thank God.",
#:   "He claims that I ran into him. I beg to differ; a person who drives forward can see where she goes. His car stood by the kerb when I entered the street. When I'd come to the florist's the back of it wasn't by the kerb any more, it was in front of my bumper and travelling towards me still.",
#:   "Mum let me press the horn! The truck was sleeping on the side. Then its bottom lights were white, and its bottom came out first, it came round on to our street, like when I go backward off the slide. The man in it was looking at the front. So I pressed, and he stopped with his bottom in our way.",
#:   "The pupil saw a parked car and therefore saw nothing. I saw that there was steam at its exhaust and a lit lamp that wasn't red. I said \"ease off.\" Then the rear of it swung wide out of the space into our strip of road, quite briskly, and my pupil said a word that they don't teach at that school of hers.",
#:   "In the end there were just two things to be measured by the constables: how far V2's tail projected from the parking lane, which was nine feet, enough to shut V1's lane; and the angle, since a car that comes out backing on full lock always sits askew. The gear lever was still in reverse.",
#:   "Was für ein Theater. I am coming with the bus, and out of the parking places something is coming to me with the buttocks first, an SUV so large like a kiosk. She has the reversing light, she has the camera, she has the peep-peep, everything she has, only not the idea to look if in the lane already somebody drives.",
#:   "You know that moment in a shark film where the water's flat and then it isn't? Same with those bays outside the gym. All the bonnets in, all quiet. Then one boot detaches itself, a pickup's, starts to arc out toward the traffic, which is to say toward us, and what you think is: there's nobody looking out of that end.",
#: ]
#: adversaries = ["car", "truck", "emergency-vehicle"]
#: requires = ["advKerb", "advRoom", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: backing up into another vehicle; own code"
#: [slots]
#: actions = ["reverse"]
#: side = "right"
#: position = "kerb"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 8.0
#: high = 34.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_ADV_BACK_SPEED"
#: low = 2.0
#: high = 3.8
#: unit = "m/s"
#: meaning = "how fast it backs up"
#: [[parameters]]
#: name = "OPT_STOP_OFFSET"
#: low = 1.0
#: high = 2.4
#: unit = "m"
#: meaning = "how far from the middle of the lane it stops"

param OPT_ADV_DISTANCE = Range(8, 34)
param OPT_ADV_BACK_SPEED = Range(2, 3.8)
param OPT_STOP_OFFSET = Range(1, 2.4)

behavior AdvBehavior():
    start = progressOn(advKerb, self)[0]
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do ReverseTurning(globalParameters.OPT_ADV_BACK_SPEED, -0.75 if offsetFrom(advKerb, ego) > 0 else 0.75) until abs(offsetFrom(ownLane(egoRoute), self)) < globalParameters.OPT_STOP_OFFSET or distanceLeft(advKerb, self, start) > advRoom
    do Halt()
