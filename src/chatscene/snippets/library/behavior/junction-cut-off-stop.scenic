#: description = "The car turns into the ego's lane, brakes hard, and stops."
#: rephrasings = [
#:   "he barges in front of us out of the side road and then slams on the anchors",
#:   "Vehicle 2 entered the lane of Vehicle 1 from the cross street, braked hard, and came to rest.",
#:   "comes into our lane at crossing, hard brake, standstill",
#:   "The target enters the lane of the VUT at the junction and performs full braking to standstill.",
#:   "The truck comes in front of the ego from the other street and then brakes until zero.",
#:   "A fire engine pushes in ahead and jams on its brakes.",
#:   "A biker takes our lane from the side street, then stops dead.",
#:   "It forces its way in ahead of the ego, only to pull up at once.",
#:   "A van swung out of the side road right in front of me, stamped on it and came to a dead halt.",
#:   "Unit 2 turned from the cross street into the lane ahead of Unit 1, braked heavily and came to a complete stop.",
#:   "Car turns in on us, hard brake, standstill.",
#:   "The target vehicle turns from the crossing road into the test vehicle's lane, then performs full braking to rest.",
#:   "A motorbike turns in my lane from the side street and then full brake and stands.",
#:   "Actor enters our lane from the cross arm, cuts us off, v goes to 0 quickly.",
#:   "It came round the corner, took her lane from under her wheels and then pulled up short.",
#:   "He's turning in ahead of you at the crossroads, he's cut you up, and now he's stopped dead.",
#:   "he turned right in front of me, braked super hard and then just stayed there",
#:   "A car swung round the corner into the motorist's lane and came to an emergency halt.",
#:   "He rounded the corner, took possession of my client's lane and brought his van up all standing.",
#:   "This lorry turn into my lane from the junction, jam brake, then stop there completely.",
#:   "Comes round the corner into my road, nicks my space and then drops the anchor for good.",
#:   "Turn-in ahead of own vehicle at intersection with full braking to rest",
#:   "TURNS IN FRONT OF ME THEN SLAMS TO ZERO",
#:   "The van hooks into our lane and halts with a jerk.",
#:   "Swings out of the side street before us, hard stop, immobile.",
#:   "SUV whips in off the cross road then anchors up completely.",
#:   "Have a pickup join from the side arm and stop violently.",
#:   "side road van took our lane stamped the brake n stood there",
#:   "Fire engine turned in ahead, heavy braking, now stationary, over.",
#:   "We were nearly at the crossroads when a lorry came off the other street into our lane and instantly braked with everything it had until it stood.",
#:   "From the intersecting road the target steers into the lane ahead of the vehicle under test, then applies maximum deceleration and remains at rest.",
#:   "Imagine: somebody pops out of the turning, he's now where you wanted to be, and straight away he's hammering the brake and going nowhere.",
#:   "My airbag went off because the cab which had just curled out of the junction into my lane did an emergency stop and remained there.",
#:   "The motorcycle comes from the transversal street, it enters itself before me in my file, and there it brakes very strong and doesn't move any more.",
#:   "Robotaxi rear camera no use here; front camera shows a police car hook in from the crossing street, dip its nose under braking and settle motionless.",
#:   "Failed case in the junction family: the NPC car on the cross arm turns into the ego's lane with a small gap, completes the turn, and then brakes at its limit down to v=0 in front of us. No drive-off afterwards. Ego braked late by 0.4 s.",
#:   "He had no business coming out at all, in my opinion. The young man brought his van out of the side street directly before me, straightened up, and then the tyres screeched and there it was, at a dead stand in my lane, with me skidding up to it.",
#:   "Vehicle 2 was at a standstill in the lane of Vehicle 1 when struck. It had got there from the crossing road only a second or two earlier, cutting Vehicle 1 off in the turn, and skid marks of eleven metres prove how heavily it was braked.",
#:   "I was cycling behind the silver estate, so I had a good seat. Out of the cross street comes a big motorbike, round into the estate's lane with hardly room to spare, and before anyone can breathe its rider has clamped on everything and stands with both boots down.",
#:   "A motorist complained of a tipper which cut round the corner into her lane at the lights in Mill Road. \"I thought, fine, go, but then he braked so sharply that his tail lifted, and he came to a stop just yards ahead of me,\" she said.",
#:   "Bike swerves out of the crossroad into our lane, emergency brake, motionless.",
#:   "Let an ambulance curl in ahead of the ego, brake violently, stay put.",
#:   "Taxi rounds the corner into MY lane and anchors to nothing",
#:   "Out of the side arm and into the space before our bumper came a police van, which then screeched down to nothing and did not stir.",
#:   "From the intersecting road the target truck takes up the lane of the subject vehicle just ahead; after alignment, maximum brake pressure is applied until v = 0.",
#:   "Where the two streets meet an SUV turned in right under my bonnet, and with no reason at all it did a full emergency stop and remained standing.",
#:   "The motorcycle of the other street has turned itself into my line, has braked like for a wall, and voilà, it was immobile before my nose.",
#:   "He's coming off the cross street and into your lane, he's taken your room, he's standing on the brake, he's stopped, and so must you be!",
#:   "Why come out of the side street and steal somebody's lane if the next thing you do is slam the pickup to a dead halt in it?",
#:   "I was two cars back on a bicycle trainer's licence, so to say, and saw it all. A fire engine nosed out of the cross street and bent round into the blue Corsa's lane with a yard to spare. Its whole front plunged; there was that squeal; and it was a red wall with the Corsa stopped an inch off it.",
#:   "Following the impact V2, a light truck, was found at rest facing the same way as V1 and in V1's lane. V2 had shortly before come round from the cross street, leaving V1 less than a second. Fifteen feet of scuff led from the corner to its rear wheels, evidence of how it had been braked.",
#:   "It smelt of rubber, that I remember. We had nearly reached the crossing, my wife was telling me about the curtains, and a motorbike came curving out of the other street to be in front of us. I saw the rider's shoulders go forward and his back wheel lift, and then he simply wasn't travelling any more.",
#:   "Bug: ego rear-ends NPC in the cut-off case. NPC turns from the crossing leg into our lane, TTC 1.6 s, drives a moment in our direction, then decelerates at 8 m/s² down to rest. The stack credits it with pulling away after the turn. It must expect the opposite.",
#:   "Pupils always think the danger's over when the other fellow has completed his turn. This lad in the Transit was out of the side road, into our lane, cheeky but finished, you'd say. But no; nose down, tyres howling, dead stop, and it was my dual brake that saved the no-claims.",
#:   "For the insurance: I was travelling straight along Mill Street at 40. The cab came from the street that crosses it and took its place in my lane when I was practically on top of it. In the same breath its driver braked with all his strength. I hit a vehicle which was standing.",
#:   "Lady in the Lexus, this one's for you. You came swinging out of Elm onto Third and into my lane, so I backed off, my bad for existing. Then you stomped that brake so hard your hazards came on by themselves, and you sat there. I had a wedding cake in the back.",
#:   "The road had been his; then a great dirty tipper heaved itself out of the cross street and it was no longer his. He gave up the yards it wanted. He was about to give it more when the air brakes went off like a shot, the wheels hopped twice, and the tipper was a building.",
#:   "It is one thing, members of the jury, to join a road from a crossing street in front of a car too near to be thus treated. It's another to brake, on completing that turn, as though a child had run out, and to remain. There was no child. There was only the accused's estate car, at a standstill.",
#:   "My scooter's got no ABS so I look far ahead, and a good job. Box van on the street that crosses ours, he sees the robotaxi, he goes anyway, round and into its lane. Before he's even straight the rear doors jump up at us. Full stop. The robotaxi dug its heels in, me too.",
#:   "Child's account, taken with mother present: \"The police car came round the corner and it went into where we were going. Then it went eeeek. It didn't go eeeek a little bit, it went eeeek till it was all stopped. And then Mummy said a word.\"",
#:   "Pickup rounds into my lane off the crossing, anchors, stationary.",
#:   "Cross-street biker takes our lane, tyres lock, finished, immobile.",
#:   "turned in on us from the side rd n slammed to nothing",
#:   "At the crossroads a fire engine came round into the lane we were using, and before its back wheels were straight it had stamped itself to a standstill.",
#:   "The trajectory of the crossing target merges with that of the VUT at the junction; full deceleration to rest is commanded after a short run in the shared lane.",
#:   "The space I was driving toward at the junction got filled by a removals van out of the other street, which next did its level best to halt on a sixpence.",
#:   "Now, madam, he's come out of that road on to your strip, that's rude. Lamps! He's locked up, he's stuck fast, so squeeze it, squeeze it, good.",
#:   "A motorcyclist who'd been going across our front thought better of it, leaned into our lane instead, and grabbed everything he had till it stood.",
#:   "Let the taxi in the intersecting street steer round into the ego's path, be in its lane for barely a heartbeat, and then go to zero as violently as tyres allow.",
#:   "In the boot there had been a wedding cake, four tiers. It survived the ambulance barging round out of Mill Lane into the place where we'd have been, since I only lifted off. It didn't survive the half-second after, when that ambulance, now straight in front of us and in our own lane, dug in and stopped as if it had hit a wall.",
#:   "The sequence on the frames: nothing in our lane, then a lorry's cab entering it from the street that crosses, then the lorry's back doors square to us. So it's joined us, says everyone. Then three red lamps, smoke from under the trailer, and doors that no longer recede but come at us, because the lorry has stopped.",
#:   "You can tell the order of events from the mud it shed. There's a curved trail from the mouth of the side road into the claimant's lane. It straightens for some two lengths of the car. Then it becomes two black stripes, and at the end of them lies a heap, shaken off all at once, where the tipper stood.",
#:   "Okay so I'm ninety per cent annoyed with myself. When the guy swung out of the cross street onto my line I relaxed, because I thought: now he is a car ahead of me like any other. Two seconds after, he's the only car on earth whose wheels are locked. I ended up reading the dealer's sticker on his boot.",
#:   "What we heard in the bakery was two squeals with a small pause in between. We ran out. The motorbike was in the lane of the little robotaxi, at a complete stop, pointing up the road as the robotaxi was, so it must have come round the corner from Church Street. The rubber on the ground reached from its back wheel almost to the corner.",
#:   "I've the greatest respect for taxi drivers, only not for that one. He arrives from the crossing street, he takes a fine quick curve, and he's the first of our queue, where I was to be the first. I say, enjoy it. And he, having won, dips his nose to the ground and rests there with me nearly on his back seat.",
#:   "My report, Sergeant, is best drawn. Here am I, going straight. Here's the junction, and this arrow bending into my lane is the police car, yours, I'm sorry to say. This cross is where it stood two seconds later. The zigzags between bend and cross are me hearing its tyres, and here, a hand's breadth short, is my bumper.",
#:   "The radar does not complain when something enters from the cross street; it gets a new lead, with a positive speed, eleven metres ahead, and opens its following distance. Then the new lead, for a reason which wasn't modelled, has minus eight metres per second squared and no speed. It is now a wall with number plates. Check the AEB timing.",
#:   "The horses felt it before I did. A young man in a hatchback had popped round out of the lane that crosses Toll Road, and was in front of my box, on my side. My brakes held his coming out; but then he threw out his anchor. Their hooves went like drums, and I stopped with his exhaust under my bumper.",
#:   "Two short hoots were all I'd breath for: one when the SUV flung itself off the crossing street into the bit of lane I was about to drive on, the other when its hazard lights and its brake lights came on together, and it had quit moving altogether while I was still doing twenty-five.",
#:   "There's a riddle in our depot. When is a gap not a gap? When a van turns in from the other road and fills it, and you, like a good bus driver, let go another gap for him. And when's that not a gap either? When he bangs on the brakes till he's stock-still, and you have fifteen pensioners in the aisle.",
#: ]
#: adversaries = ["car", "truck", "motorcycle", "emergency-vehicle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["cut-in", "brake", "stop"]
#: position = "crossing"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 5.0
#: high = 28.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 6.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it comes in"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.5
#: high = 2.0
#: unit = "s"
#: meaning = "how long it drives in the ego's lane before it brakes"

param OPT_ADV_DISTANCE = Range(5, 28)
param OPT_ADV_SPEED = Range(6, 9)
param OPT_STOP_TIME = Range(0.5, 2)

advTurn = ("straight", "right-turn", "left-turn")

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 3.5
    do DrivePath(egoRoute, globalParameters.OPT_ADV_SPEED) for globalParameters.OPT_STOP_TIME seconds
    do BrakeOnPath(egoRoute)
