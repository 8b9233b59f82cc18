#: description = "The car turns right into the ego's lane and brakes to a stop."
#: rephrasings = [
#:   "he whips round the corner in front of us and stands on the brakes",
#:   "Vehicle 2 turned right into the lane of Vehicle 1, braked hard, and stopped.",
#:   "right turn into our lane, then hard brake, standstill",
#:   "The target turns right into the lane of the VUT and then decelerates to standstill.",
#:   "The bus turns to the right in our lane and immediately it brakes until it stands.",
#:   "A taxi rounds the corner rightward and pulls up sharp.",
#:   "The biker hooks right ahead of the ego, then jams on the anchors.",
#:   "Having come out of the side street to its right, the lorry stops dead in our way.",
#:   "he came out right into my lane from the side road and then pulled up dead in it",
#:   "V2 turned right into V1's lane and braked to a complete stop ahead of it.",
#:   "Bus: R turn into our lane, brk, standstill.",
#:   "The target turns right into the VUT's lane and decelerates to standstill directly ahead of it.",
#:   "The truck turns right in my lane and then he brakes and stays standing before me.",
#:   "Right-turn merge followed by a stop: NPC aligns with the ego lane after the corner, then v=0.",
#:   "The motorcycle had come round the corner to the right to join them on their road, and hardly straight, it braked and stood.",
#:   "He's swung out right, he's in your lane now, and he's stopping! What did he come out for if he's only going to stop?",
#:   "he turned right into our lane then just braked and stopped, like why",
#:   "A lorry rounded the corner to the right, took the lane and at once pulled up",
#:   "You came round to the right into my client's lane and, once in it, braked until you stood?",
#:   "Bus turn right come into our lane, never drive on, straight away brake and stop",
#:   "Comes round the corner, right into my lane, and then drops it on a sixpence",
#:   "Right turn into own lane with subsequent hard braking to standstill",
#:   "Biker turns right into my lane and STOPS DEAD",
#:   "The pickup rounded rightward into our lane and clamped up.",
#:   "Side-road bus goes right, joins our lane, brakes, stands.",
#:   "pickup made the right in ahead of me then brakd n stopped stone dead",
#:   "Let a biker take a right onto the ego's road and halt.",
#:   "Veh 2 right turn, entered subject's lane, brake application, full stop.",
#:   "He came out to the right, in my place, braked, no more moving!",
#:   "From the street on the side a lorry made a right-hander into our lane, and before its tail had even straightened the driver had braked it to nothing.",
#:   "After a right turn into the lane of the vehicle under test, the target proceeds for a short time and then applies its brakes until at rest.",
#:   "Mirror, brakes, and watch the taxi: he turns right, now he's directly in front of you going your way, and blow me, he's pulling up.",
#:   "The motorcycle has taken to the right for to come in my line, it has braked at once and has remained planted in front of me.",
#:   "What do you call someone who turns right out of a side road into the lane you're in, slows hard and then won't go another inch?",
#:   "Parked? No, it stood in the live lane, that coach, having reached it by a right turn from the crossroad and then been braked to a standstill.",
#:   "I was on the main road and the young lady in the hatchback was waiting at the side. She turned right, which put her in my lane just before me, and I thought, well, she'll speed up. Instead her brake lights came on and stayed on until she'd stopped.",
#:   "Vehicle 2, a box van, executed a right turn from the intersecting street into the lane occupied by Vehicle 1. Roughly two seconds afterward the van's driver, who was looking for a house number, braked firmly. The van had come to rest when the front of Vehicle 1 struck its doors.",
#:   "Can we get a case for this? The crossing pickup turns right, aligns itself with our lane as a fresh lead vehicle, travels a few metres like that and then decelerates to v=0 and holds. ACC accepts the new lead too late. Don't confuse it with the variant that turns and merely crawls.",
#:   "There are eighteen tonnes of me, so choose your moment, I say. This scooter lad picked the worst. Round to the right he comes, out of the lane by the church and smack into mine, with me thirty yards off; then he pulls both levers and stops there, feet down, to answer his phone.",
#:   "We begin the podcast with Gerald, who is eighty and drives a bubble car. Gerald turns right out of his road, taking his place in the lane ahead of a robotaxi. Gerald then remembers the oven. Gerald stands on the brake till nothing moves, and the robotaxi has to do something about it.",
#:   "Truck comes round to the right into our lane, brakes, stands.",
#:   "Cab off the cross street: right-hander in front of the AV, brakes, standstill.",
#:   "SUV rights out of the side street into me lane, anchors on, parked",
#:   "From the crossroad a scooter went right and found itself in our lane, just ahead; after a short hop along it, the rider pulled both brakes until he stood.",
#:   "The target executes a right turn onto the VUT's path, follows that path briefly, and decelerates at a high rate to a stationary state in front of it.",
#:   "The van turned to the right-hand, so he was in my lane, in my direction, good; but then he braked fully and was not moving any centimetre more.",
#:   "Bus on the side road's turning right, so it's in your lane, in front of you. Now what? It's braking. It's stopped. Which means you are too.",
#:   "Having turned right, and having thereby become the vehicle ahead of my client in her lane, did you not brake so as to stand there?",
#:   "All that turning right to get in ahead of the robotaxi, and then the pickup braked and sat in its lane like a cow on a railway.",
#:   "I thought he'd come for the petrol, there's a station just beyond. The tanker came out of Quarry Lane with a right-hander, nice and wide, and took his place in front of us in our lane. He'd gone maybe two lengths. All six of his rear lamps came on together and we watched them stop getting farther away.",
#:   "V2 was stopped for traffic on Dell Road. Its operator, a 19-year-old female, turned right onto the highway into V1's lane at a distance of some ninety feet. She then heard her phone fall, and applied the brakes. V2 was stationary in the lane, headed the same way as V1, at the time of contact.",
#:   "A turn to the right is the easiest thing in the world, I tell them, until you've done it. This lad did it all right: he rolled out on his motorbike, got into our lane, was our new leader. Then he recalled that he had no petrol cap on. Front brake, back brake, boots down, right there.",
#:   "The robotaxi had been promised, as it were, a companion. The dark saloon came round the corner rightwards into its lane, and straightened, and for the space of two heartbeats the pair travelled in convoy. Then the leader's lamps burned red; it dug in; the convoy was a car at a stand and another bearing down on it.",
#:   "Issue #77: new lead vehicle after junction. It enters from the cross street with a right turn and has our heading and lane by 6.2 s. From 7.9 s it brakes with at least 5 m/s² and reaches standstill in lane at 9.4 s. We treated the brief acceleration phase as a commitment. Nope.",
#:   "How can I be at fault? He faced across my road, he turned by his right hand, and so he came into the lane in which I'm driving thirty years. If he had gone on, we'd have been two cars. But he has braked, my friend, as if before a cliff, and he remained there, and so we were one.",
#:   "The pupils on the top deck thought it was a joke. A bus from the other school came out of Hill Rise, to the right, into our lane, with its pupils making faces in the rear window. We were catching it up. It braked, and the faces went flat; and at the end it was standing and so were they.",
#:   "The skid begins eleven metres past the corner. It is the skid of a lorry which has just turned right out of Mason Street and is now in lane one, the claimant's lane, going the same way as he. The skid ends where the lorry ended its motion. There is no earthly reason for the lorry's having stopped.",
#:   "Bread van, six in the morning, I'm on my way to the allotment on the pushbike, behind a robotaxi. The van's in a side turning. Out to the right he comes, so now he's leading the robotaxi down our lane. He's found that a door's open, though. He brakes hard, rolls hang about, and there he's stuck.",
#:   "Grandma asked why we had no eggs left. So. A taxi was in the little street, and it made a right into ours, and it was in our lane before us, and I said \"oh good, it's going to the market too.\" It wasn't going to anything. It put its brakes on right away till it was all still.",
#:   "Radio check, I've a hatchback halted in the live lane at the foot of Spring Gardens. Driver says he had only just come out to the right from there, got into this lane, thought he'd a puncture, and braked to a stand. Motorist behind him had to do the same in a hurry. Send recovery.",
#:   "SUV bears right into our lane, drives a bit, anchors to rest.",
#:   "Right-hander into my lane, brake lights, dead stand. Thanks, minibus.",
#:   "truck hangs a right, joins my lane, brakes till hes parked",
#:   "By its right-hand turn the motorbike had become the next vehicle in our lane, and by its brakes, two heartbeats later, the next obstacle.",
#:   "It nosed out, that hatchback, came round clockwise till I had its number plate before me, kept me company for some metres, and dug in till it stood.",
#:   "From the side road bring a coach round to its right into the ego's lane; give it a second or so at speed; then brakes, down to nothing, and leave it.",
#:   "Following a right turn that ends in the lane of the VUT, the target holds its speed for the set time, whereupon the service brake takes it to rest.",
#:   "The claimant's lane was joined by a tipper which had veered right off the cross street, and which repaid her making room for it by braking to a dead halt.",
#:   "Two corners has the story: the one he took, to his right, so as to be my leader, and the one I had nearly to take, as my leader braked and stood.",
#:   "I let him have it, that's what galls. His van was at the mouth of the turning and wanted to go right, which is to say my way, in my lane. Fine. I backed off for him. We weren't past the second lamp-post when his rear was all red lamps, and it stayed all red lamps, and it was stationary. He wanted the paper shop.",
#:   "For three seconds the robotaxi had been on its own, for two it had a follower's job, and then it was part of a jam of two vehicles. The middle bit started with a cab's right turn out of Orchard Street, straight into its lane. The last bit began with the cab's nose going down and ended with the cab not moving.",
#:   "Marks on the road, from west to east. A curve, faint, of a wheel loaded on its left, from the mouth of the cross street round to the right, into lane one. A piece without any marks, nine yards. Two straight ones, black, eleven yards. The motorbike's side stand, at the end of those, had left a dent where it was put down.",
#:   "He needn't have come out, there was nobody behind us for a mile. But he put that big rump of a bus round to the right, in under our noses, and went along our lane as though he meant to stay on it. I was reading out his advert. At \"Visit\" we were fine, at \"beautiful\" his brakes bit, at \"Whitby\" neither of us was moving.",
#:   "The indicator, I'm told, was for me: right, right, right. His turn was all that an examiner could wish for and it put him in the lane I was in, heading as I was heading. I'd tucked in behind when that same examiner must have shouted \"stop!\", as he hit the brake and left the thing standing there with me in its boot.",
#:   "In the occupancy plot a second box enters our corridor at the junction, rotated by ninety degrees to its right until it's parallel to ours. From frame 30 to 55 it moves on within the corridor. From 55 its length per frame decreases hard, and from 71 it doesn't move. What we report as \"cut-in\" should therefore have a second label.",
#:   "It's the second surprise that does it. The first, a saloon doing a right-hander from the side street bang into my lane, I'd dealt with, and my sidecar too. I was changing up again. The second was that the saloon's weight all went forward and that its wheels, which had had no time to get warm, came to rest.",
#:   "With the bread in the back one drives by the nose. I smelt him before I saw him, a diesel from the street to the side. It swung itself to the right, on to our lane, and I thought: so, a lorry in front, I will read his tarpaulin. But his red lamps wrote STOP, he has stood, and all my croissants were in the front.",
#:   "I don't believe the post van was after anyone. It came from the other road, round by its right, and led us on a few yards, quite decently, in the lane where we were. What did happen is that its brakes came on in earnest; it squatted, it stood; and the postman got out for a parcel that was lying on the verge.",
#:   "Look who's arrived in your lane, a pickup, by way of a right turn and no glance at you. What'll he do next? Don't know? Nor do I, so we hang back. He's picking up... no. He's braking, he's braking right down, he's standing. Had you sat on his tail like you wished you'd be in with his ladders.",
#:   "To the council, about the turning at the dairy. Vehicles come out of it to their right and so into our lane, that's what it is for. On Tuesday one of them, a tall red lorry with a crane, had been in our lane for the time it takes to say so when it was braked to a stop and not moved again. We were in the ditch, kindly.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["turn-right", "brake", "stop"]
#: position = "crossing"
#: side = "right"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 25.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 8.0
#: unit = "m/s"
#: meaning = "how fast it turns"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 2.0
#: high = 3.5
#: unit = "s"
#: meaning = "how long it drives in the ego's lane before it brakes"

param OPT_ADV_DISTANCE = Range(0, 25)
param OPT_ADV_SPEED = Range(5, 8)
param OPT_STOP_TIME = Range(2, 3.5)

advTurn = ("straight", "right-turn")

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 6
    do DrivePath(egoRoute, globalParameters.OPT_ADV_SPEED) for globalParameters.OPT_STOP_TIME seconds
    do BrakeOnPath(egoRoute)
