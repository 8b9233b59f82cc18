#: description = "The crossing car drives straight through the intersection in front of the ego."
#: rephrasings = [
#:   "A vehicle from another arm passes through the junction without yielding.",
#:   "The adversary goes straight over the crossroads at an even speed.",
#:   "Cross traffic moves through and cuts the ego's way.",
#:   "The other car traverses the junction first.",
#:   "The lorry rolls straight across before the ego.",
#:   "he just drives straight over as if we weren't there",
#:   "Vehicle 2 proceeded straight through the intersection on a perpendicular path.",
#:   "The target crosses the path of the VUT at constant speed (straight crossing path).",
#:   "chap on a bike sailed over the crossroads right before I got there, didn't turn or anything",
#:   "Vehicle 2, eastbound, continued through the intersection on a path perpendicular to that of V1.",
#:   "Truck from side arm: straight over, our path, steady.",
#:   "The crossing target traverses the junction perpendicular to the VUT without turning or changing speed.",
#:   "From the side comes one bus and it goes just straight to the other side before me.",
#:   "Plain cross-traffic actor, goes in one side of the junction and out the other, no tricks.",
#:   "A motorcycle came from the side street and went on over before them and out the far side, neither hurrying nor slowing.",
#:   "Right, van from the side road, he's going straight ahead over the crossroads in front of you, just let him through.",
#:   "some van just went straight over in front of us, normal speed, didnt even look",
#:   "The bus carried on over the crossroads from the side road, passing before the waiting doctor's car",
#:   "He held a straight course from one side to the other, at an even pace, across my client's front?",
#:   "One lorry from the side road went straight straight in front of us and gone to other side",
#:   "Bus trundles out the side road and over the top, straight on, never mind me",
#:   "Perpendicular crossing traffic at constant speed; no turning, no stopping",
#:   "Cyclist rolls straight across the intersection in front of me",
#:   "The pickup bisected our route at the crossroads.",
#:   "Pickup comes out of the left arm and carries straight on through.",
#:   "Crossing bus passes ahead of the AV, side road to side road.",
#:   "Cross-street scooter goes right through the box before we reach it.",
#:   "The lorry sliced the junction in two, straight ahead, under our nose.",
#:   "Want: bike from the side, dead straight over the crossroads, even speed.",
#:   "As the subject vehicle nears the junction, a cement mixer on the intersecting road moves through it without turning and leaves by the opposite exit.",
#:   "My passenger shouted because a taxi was emerging from Church Street, and it kept right on into Church Street on the other side, clean across our path.",
#:   "The crossing object enters the conflict zone at a constant 30 km/h, maintains its heading and exits on the far arm ahead of the VUT.",
#:   "Have a coach approach on the transverse road and drive over the intersection in a straight line so that it gets there ahead of our robotaxi.",
#:   "Der Radfahrer kommt, I mean the cyclist is coming on the crossing street and he traverses the junction before my car, always straight.",
#:   "You've got a motorbike on the road that cuts ours; he's not turning, he'll be through the middle and out over there before you're at the line.",
#:   "We were on the main street, about to go into the junction, when this bread van turned up on the road that crosses it. It didn't turn left and it didn't turn right, it just drove on through the middle ahead of us and into the road opposite.",
#:   "V2 was northbound on 5th Avenue and V1 was westbound on Pine. V2 entered the intersection first and kept its heading at approximately 25 mph, occupying the space immediately ahead of V1 before departing over the north leg.",
#:   "I was on my bicycle, and my route goes from the allotments on one side of the main road to the school on the other. So I rode across the junction, in one line and without rushing, and the driverless car coming along the main road got me broadside in its cameras.",
#:   "\"There goes the brewery lorry,\" said my uncle, and there it went indeed, out of the lane on our right, through the crossing before our very radiator and into the lane on our left, as straight as a ruled line and at a sober speed.",
#:   "Scenario request: perpendicular paths at a four-way. The other party, a saloon, sits on the intersecting road and traverses the junction with steady speed and no steering, timed so that it passes just ahead of the ego's front bumper.",
#:   "Side-street milk float goes clean over, ahead of our bumper.",
#:   "In at the west arm, out at the east: one lorry, first.",
#:   "The cyclist from our right just rolls across the crossing, no turn.",
#:   "An articulated vehicle on the road at right angles to ours went over the intersection without altering its course or pace, and was clear only just before we came.",
#:   "I saw the whole length of the coach go by in front of me as it made for the street facing the one it had come out of.",
#:   "Let a scooter on the intersecting road keep on straight at a constant clip and get through the middle right ahead of the ego.",
#:   "The conflict partner approaches from a lateral arm, does not steer, does not decelerate, and vacates the intersection via the arm opposite prior to the VUT's arrival.",
#:   "Didn't give way, did he, that cab from the side, just carried on over the crossroads under our noses and off down the other street.",
#:   "Car is coming from left-side road, I am on main, he is going straight only, passing before my bonnet at same speed and finished.",
#:   "A wall of red went past my windscreen, left to right, with a row of bored faces in it, and then the other half of the crossroads was back. That was the 43. It'd come along the road that cuts ours and it was carrying on along the same road, at its usual gait.",
#:   "V1 was eastbound approaching the intersection. The operator of V2, a pickup truck, was southbound, entered ahead of V1 and continued southbound at an unchanged speed. Paint transfer indicates V2 was wholly perpendicular to V1 and about to leave by the south leg when V1's bumper brushed its tow hitch.",
#:   "I've only the one headlamp on the old BSA, so perhaps the clever car did not see me. I was on the lane from the mill, and the lane goes over the high road and on to the ford. Over I went, steady as you like, neither left nor right, and it pulled up with its nose at my boot.",
#:   "The bell of the level crossing was ringing somewhere and the child had just asked for a drink. So neither of them marked the furniture van until it had come out of the mouth of Cooper Street. It slid through the space before them, unhurried, without a turn of its wheels, and Cooper Street's other half took it in.",
#:   "Short one from this morning. Green hedge both sides, can't see a thing, I'm nearly at the crossroads, and a lycra guy on a racing bike is suddenly a cyclist-shaped hole in my view, passing from my left mirror to my right mirror dead straight. He was in the far road before my tyres stopped.",
#:   "Now tell me what that mixer's front wheels say. Pointing straight, aren't they, and no indicator, so he won't come into our road at all. He'll go from his side, through the middle where we'd be, to the other side, and at that speed he'll be there first, so cover your brake.",
#:   "Since the lights were out after the storm, everybody was supposed to take turns. The minibus on the cross street didn't. It entered at about twenty-five, went over at about twenty-five in front of the robotaxi and left, at about twenty-five, down the continuation of the street it had come by.",
#:   "Scenario card, class SCP. Other participant: motorcycle, path perpendicular to subject vehicle, heading constant, speed constant at 10 m/s. It is to be the earlier of the two at the crossing point by roughly a second. No turning, no braking and no reaction to the subject vehicle.",
#:   "My Lord, my client drives a hay wagon behind a tractor lorry, if one may call it so. It's not disputed that he came by the drove road and meant to stay on it, nor that the drove road traverses the A-road. He did traverse it, straight and at his usual pace, and the plaintiff arrived second.",
#:   "What I remember is the smell of bread. The baker's van does its round through the side streets, and it passed crosswise through the junction when we were perhaps two car lengths short of it. It didn't turn into our street, as I'd hoped, but went on into the next one over there, not faster and not slower.",
#:   "In the field of the cross-view camera a box labelled TRUCK appears at the left edge, travels to the right edge in 2.8 seconds and disappears there. Its path is a horizontal line and its speed does not vary. During those 2.8 seconds the AV, which had been about to enter the same junction, stood on its brakes.",
#:   "Out of one side street, into the other, right past our bumper.",
#:   "The lorry beat us to the crossroads and went clean over.",
#:   "Make a bus bisect our path at the junction, no turn.",
#:   "Where I'd expected tarmac there was suddenly a horsebox, side-on and moving, bound from the lane on our left to the lane on our right.",
#:   "From the fact that both dents are on its flank and none of its wheels was turned, V2 was passing straight through on the cross street.",
#:   "I was two lengths short of the junction when a rider from the other road went over it ahead of me, upright, at one speed, not bending either way.",
#:   "Did that milk tanker even know that there was a main road? It went over ours as though the two halves of its lane had never been parted.",
#:   "The crosser is to come in by the lateral arm, stay on its heading at eight metres a second and be out by the facing arm ahead of the VUT.",
#:   "For one and a half seconds the traffic light opposite was hidden from me, and what hid it was a bus taking the crossroads from side to side at a normal trot.",
#:   "My sister always says \"clear left\" and she'd said it. So it was a shock when the left-hand house corner gave birth to a cement lorry. It neither turned towards us nor away. The drum went by our windscreen, revolving, and then the right-hand house corner had swallowed it, and we were standing on the stop line.",
#:   "Drone footage, third clip. Two streets make a plus sign. The little white car that's us comes from the bottom. A brown one comes from the left and goes to the right in a line you could rule, as far as the end of the picture, and where the lines cross it's the brown one that has been there first.",
#:   "The kids on the bus all waved, that's how near it was. I had the pram of my neighbour's in the boot and I'd been told to be careful. They were on Ash Street; they'd been on Ash Street before the junction and were on Ash Street after it. In the middle of it I had sixty hands in front of my bonnet.",
#:   "An oil spot was found every four feet. They begin on the minor road to the north, continue over the intersection without a bend and without getting closer to each other, and end in the minor road to the south. So the motorcycle with the leak had driven through ahead of Vehicle 1, neither slowing nor steering.",
#:   "What's the first thing you do at a crossroads? You look at who's on the other street. This pickup is, and he's rolling. No blinker. Wheels straight. So where will he be when we'd be in the middle? In the middle. Let his tail go past, there, now he's in the street across from where he came.",
#:   "I'd like the plainest conflict that two roads can make. We come along ours. The other one, a cyclist for instance, comes along the road that's at right angles. He has nothing to do in our road but to get over it, so he holds his line and his pace and is through just as we arrive.",
#:   "The accident sketch by my client, an artist, is perhaps too beautiful. In the foreground, our radiator. Beyond it, huge, a wall of hay bales on wheels, travelling out of the drawing at the right while its tail is still coming in at the left. The tractor lorry had come by the byroad and was going on by the byroad.",
#:   "\"Hold it!\" said Nan, so I held it. There's no wall at that corner but there's a hedge that's as good as one. And from behind the hedge came the library van, square across the front of us, doing its twenty like on any Tuesday. It had its own road to follow and it followed it, ours just got in between.",
#:   "The lidar had a truck-sized object on the left arm with lateral velocity 7.9. Since there was no yaw whatsoever the turn hypotheses were dropped one after another. What remained was the one that came true: it occupied the junction centre at 7.9, two metres before our front, and vacated it by the right arm at 7.9.",
#:   "Hello, it's about the number 7. I'm not cross. I sat upstairs in front and I'm afraid of that junction since the roads meet so blindly. Your driver didn't turn, we never turn there, he just went ahead over the big road with a car coming along it. I looked straight down on its roof lights as it pulled up.",
#:   "In our town there is a crossing which is called \"the scissors.\" I was in the one blade, the taxi was in the other. He did not look, he did not bend, he did not press or brake, he simply continued his own street to where it continues after mine. The difference between us was the length of one dog.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["follow"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 12.0
#: unit = "m/s"
#: meaning = "how fast it crosses"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_SPEED = Range(5, 12)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
