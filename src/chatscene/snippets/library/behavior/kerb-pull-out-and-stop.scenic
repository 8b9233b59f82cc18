#: description = "The parked car pulls out from the kerb and stops in the ego's lane."
#: rephrasings = [
#:   "The parked car swings out and then just stops in front of us.",
#:   "Vehicle 2 pulled away from the curb and halted in the travel lane.",
#:   "Parked veh pulls out, then stationary in our lane.",
#:   "The target leaves the parking strip and comes to standstill in the path of the VUT.",
#:   "It comes out from parking and stays standing on our way.",
#:   "The van stalls the moment it has left its bay and bars the lane.",
#:   "A bus departs from the stop and freezes with our lane full of it.",
#:   "The taxi moves off the roadside, the driver sees us and seizes up before us.",
#:   "some wally came off his parking spot into my lane and then just stood there",
#:   "V2 pulled away from the curb into the traffic lane and then halted, blocking V1.",
#:   "Parked bus -> out into our lane -> standstill.",
#:   "The target leaves the kerbside, enters the VUT's lane and brakes to a standstill in it.",
#:   "The car goes out from the parking, but in my lane he stops and does not drive.",
#:   "Parked actor enters our lane then v=0 there; it must not drive on.",
#:   "The motorcyclist had nosed off from the pavement into the lane and there, of all places, come to a halt.",
#:   "Out he comes from the parked cars, and now he's stopped bang in your lane. What was the point of that?",
#:   "parked car comes out into our lane and then just... stops?? why",
#:   "A florist's van had no sooner left its parking bay than it ground to a halt, barring the way",
#:   "You left the kerb, you entered the lane, and there you stood still; can you tell the court why?",
#:   "The bus came out from the side and then halted in our lane itself, no going forward",
#:   "He comes off the side, into my lane, and then stays put, like he's forgotten where he was going",
#:   "Departure of parked vehicle into own lane followed by stationary blockage",
#:   "Parked van pulls out and DEAD STOPS in my lane",
#:   "The parked ambulance budged out into our lane and balked.",
#:   "Moped leaves its parking space, gets in our way, and there it rests.",
#:   "The parked lorry is on the move, it's in your lane, it's stopped!",
#:   "Kerbside ambulance rolls out, then blocks the lane standing.",
#:   "Let a roadside van enter the ego's lane and park itself right there.",
#:   "That bus went out of its bay and then did not budge from before us",
#:   "hatchback that had been sat at the pavement moves off in front of me, comes fully into my lane and stops like the engine died, wtf",
#:   "The vehicle stationary at the roadside shall depart, occupy the lane of the subject vehicle and there be decelerated to standstill.",
#:   "He had waited all morning in that lay-by, and yet he chose this instant to come out, only to stop again three yards on in front of us.",
#:   "Imagine a fire engine leaving the kerb, putting itself square in the robotaxi's lane and halting there, crew climbing out with the hose.",
#:   "V2's driver stated that he'd moved away from the curb, noticed his door was open, and stopped with his vehicle wholly in the lane.",
#:   "My friend, if you come out from the parking side, at least go! This auto came out and in the lane itself he stood.",
#:   "The motorcycle was leaning by the kerb with its rider aboard. As we came near he paddled it out, got the whole machine into our lane, and then sat there at a standstill fumbling with his gloves while we bore down on him.",
#:   "Claim details: third party was parked on the nearside outside the bakery. He set off into my lane without looking, and hardly was he in it when he brought his car to a stop, leaving me with a stationary tail to stare at.",
#:   "I do this street every day with eighteen tonnes behind me and I always expect somebody to come off the kerb. What I don't expect is for him to come right out into my lane and then simply cease moving, all of him, dead in my road.",
#:   "Scenario 12 in the urban set. A parked vehicle begins to move when the AV is about thirty metres away, merges fully into the AV's lane, and then brakes until its speed is zero; it doesn't drive on and it doesn't reverse.",
#:   "The old man in the Volvo had been asleep at the side of the road, I'm sure of it. He woke, steered out from the kerb into the lane ahead of her, and there, as though the effort had worn him out, he came to a halt.",
#:   "Milk lorry leaves the kerb, takes our lane, dies there.",
#:   "Off the pavement edge, into my lane, and there it stuck, motionless.",
#:   "Bus quits its stop, plugs our lane, zero km/h, end of message.",
#:   "If you give up a parking space, at least drive away; this Skoda moved out as far as the lane in front of us and went to sleep.",
#:   "The hitherto stationary kerbside target departs, becomes fully aligned with the VUT's lane and is decelerated to rest therein.",
#:   "He had been parked by the baker, he drove himself into my lane, and in this lane he made standing, with motor running.",
#:   "Set up a police car at the roadside that comes away from the kerb, gets itself right into the ego's lane and halts there for good.",
#:   "From a parked position at the east curb, V2 moved into the southbound lane and was stationary in that lane when struck in the rear by V1.",
#:   "A scooter that had been leaning on its stand was walked out, mounted and ridden into our lane, only to be stopped there while its rider checked a message.",
#:   "I saw the front wheels turn out from the kerb and I thought, fair enough, he'll be up to speed before I get to him. Up to speed! By the time I got to him there was a camper van standing right in my lane, with the handbrake on for all I know.",
#:   "The reason my shopping is all over the footwell is a blue Corsa. It had been minding its own business at the side of the road; then it came out, it filled the lane that I was in, and there it ceased to do anything whatever.",
#:   "It's not the leaving that gets you, it's what comes after. Fellow lifts off the kerb in his flatbed with you thirty yards back, all well and good, he's in your lane now. And he's stopped. Not slowed, stopped, square in the middle of it.",
#:   "The removal truck's indicator winked, the truck drew out from the row of parked cars, and we eased off to let it get away. It did not get away. When the whole of it was in front of us, straight in the lane, it gave a shudder and stayed where it was.",
#:   "A hundred and twelve parking departures are in our data, and all but one end with the departing vehicle driving off. In the remaining one it comes fully into the subject vehicle's lane from the kerb, brakes until it's at rest and remains there as an obstruction.",
#:   "What would you do here? There was an ambulance waiting at the side, it's moved off, it's ahead of you in the lane. Now look at its wheels. They aren't going round, are they, so neither should ours be.",
#:   "Mr Okafor's taxi had stood outside the hotel since noon. At ten past one it rolled from the kerb into the path of a delivery car, whose driver expected it to accelerate; it came instead to a complete halt in the lane, because a guest was running after it.",
#:   "I'm on two wheels and I look for exhaust smoke along the parked cars, so I wasn't surprised when the hatchback came off the kerb. I was surprised when I found it at a dead stop in the lane with a grey saloon behind it, nose down and hooting.",
#:   "The old lady next door says the devil gets into that bus. It stands at the stop for ever with nobody getting on, then out it lurches just as somebody's coming, all the way into the road, and then it stands there again, only this time in your way.",
#:   "We'd hardly any warning. There was a line of parked vehicles; one of them was no longer in the line but in the lane; and a second after that its brake lights were on and it wasn't going anywhere, so neither was the robotaxi, which had pulled up a yard behind.",
#:   "Why always before me? From parking side one Innova came out, fully in my lane he came, I thought he will go. But there itself he stopped, opened glass and started to talk to the coconut seller, and I was standing behind like his servant.",
#:   "Parked there, moving, in my lane, parked here. All in five seconds.",
#:   "The ambulance merely swapped its kerb space for the middle of our lane.",
#:   "Left the kerb only to go to sleep in front of us.",
#:   "A row of parked cars lost one, and our lane gained it, wheels straight, brake lamps on, not another inch of movement in it.",
#:   "The camper's journey was four metres long, from the roadside to the centre of the lane ahead of me, where its handbrake was heard going on.",
#:   "Have a motorbike start from the pavement's edge, take up the ego's lane entirely and then be at zero there, remaining so for the rest of the run.",
#:   "I lifted off so that the lorry could get away from its parking place, and it thanked me by going dead as soon as the whole of it was before me.",
#:   "Following departure from the curb space V2 was positioned squarely in the travel lane, in which it was at rest, engine running, when V1 came upon it.",
#:   "He has left his park place, good, he is now complete on my lane, also good, and there he makes nothing more, the wheels are sleeping.",
#:   "The gap that the taxi left by the pavement was still steaming, if you see what I mean, from its exhaust. It hadn't gone far. It was the thing in front of our bumper, taking up our lane from one line to the other, and to judge from the driver's elbow on the sill it meant to remain there.",
#:   "I was taught to look for heads in parked cars, so I'd seen hers. I saw the wheel turn as well, and I gave her the room, all of it. Only it turned out that she wanted my lane for standing in. She was straight, she was in it, her lights went red, and they stayed that way.",
#:   "The obstacle at station 0+140 wasn't on the map because a moment earlier it hadn't been in the road. It had come in from the kerb under its own power, aligned itself with the lane and braked out. Treat it from then on as a stationary object; it neither proceeds nor goes back to its space.",
#:   "We ended nose to bumper, and I got out to ask. He'd been waiting at the side for his wife, he said, and had set off without her, and as he'd got into the lane he had noticed. Well, that's no reason to pull up there, I told him, with my bonnet in his boot.",
#:   "There was the noise of a big diesel clearing its throat, the bus swung its behind off the kerb and the whole length of it came into line ahead of the robotaxi. Then the noise gave out. The doors opened again, in the middle of the road, for an old lady who had been running.",
#:   "Isn't it always the one you've stopped worrying about? The hatchback had been sat by the hydrant; it'd come away; it was in the lane, pointing the right way, so on to the next thing. And there was no next thing, as the hatchback was the next thing: dead still, right across my path.",
#:   "My statement concerns the fire officer's car. It was stationary by the roadside when I first saw it, and stationary when I hit the bollard avoiding it, but those were two different places. In between it had moved over into my lane, which took perhaps two seconds, and come to rest again in it.",
#:   "I've got eighteen gears and I'd just picked one. Lad in a flatbed at the side had been making eyes at the traffic, found his slot before me, rolled off into it, lovely. I went up a gear. His wheels had stopped by then. I don't mean slow. I mean there were sparrows on the road in front of them.",
#:   "What woke the baby was the horn. It was ours. The silver car had been asleep beside the pavement like all the others, and then it had rolled out until it was right in front, neatly in our lane, as though it had come to collect us; and then it just didn't go, and its driver was looking for her glasses.",
#:   "Dash cam, 08:51. See the Transit at the kerb, wheels turned? He's off. He's in. And freeze it there, because he does: the speed of that van, from the second when it's fully in the lane, is nought, and my clip runs on for another forty seconds of its back doors.",
#:   "Every morning one school rickshaw is resting below the neem tree at side. Today I was near, he woke up. From side he came in my lane, full he came, straight also. I was thinking, go baba, go. He did not go. One bag had fallen, so there only, in the centre of my way, he stood.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advKerb", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "stop"]
#: position = "kerb"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 16.0
#: high = 36.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.0
#: high = 5.5
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.4
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_DISTANCE = Range(16, 36)
param OPT_ADV_SPEED = Range(3, 5.5)
param OPT_BRAKE = Range(0.4, 1)

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3) for 0.3 seconds
    do DrivePath(ownLane(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(ownLane(egoRoute), self)) < 1.1
    do BrakeOnPath(ownLane(egoRoute), globalParameters.OPT_BRAKE)
