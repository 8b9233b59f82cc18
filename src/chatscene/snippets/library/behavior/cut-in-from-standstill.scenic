#: description = "The car stops in its own lane, waits and then pulls out of the queue in front of the ego."
#: rephrasings = [
#:   "The neighbour is stuck in his queue, then suddenly swings out right in front of us.",
#:   "Vehicle 2 was stopped in the adjacent lane and then entered the path of vehicle 1.",
#:   "Adjacent veh stationary, then pulls into our lane.",
#:   "The target stands in the neighbouring lane and merges from standstill as the VUT approaches.",
#:   "It waits on the other lane and when we come it goes out to us.",
#:   "A bus halted alongside decides to get round the jam and swings over.",
#:   "The biker sits in the standing traffic next door and then hops across.",
#:   "A lorry at rest beside our lane lurches into it without a glance.",
#:   "The car was stuck in the stationary line next to me and after a bit he lost patience and lurched out in front.",
#:   "Unit 2 was stopped in traffic in the adjacent lane, then left the line of vehicles into the path of Unit 1.",
#:   "Van halted in adj. queue, waits, then out in front of us.",
#:   "The target vehicle comes to a halt in the neighbouring lane, remains there for a short period, then changes lane from rest ahead of the test vehicle.",
#:   "A truck stands in the other lane, waits some time, then goes suddenly out before me.",
#:   "Actor stationary one lane over; after a dwell it starts and cuts into our lane from zero speed.",
#:   "He had been sitting in the jam beside her, and just as she drew near he got fed up and swung out of the line.",
#:   "See that motorbike standing in the next line? He's biding his time, and yes, he's jumped out of the queue on you.",
#:   "the car was stuck in the line next to me n then just hopped into my lane from a dead stop",
#:   "A van that had been standing in a tailback broke ranks into the path of passing traffic.",
#:   "You were at rest in the column of cars; you tarried; and then you emerged before my client, is that the size of it?",
#:   "He was stopped in that side jam only, then lost his patience and put the car in my lane from zero.",
#:   "Stuck in the next queue, twiddling his thumbs, and guess whose lane he jumps into the moment I'm there.",
#:   "Entry into own lane from rest by queued vehicle of the neighbouring lane after waiting",
#:   "QUEUE ESCAPEE pops out from standstill right in front of me",
#:   "The halted truck bides its time and then peels off the jam into our lane.",
#:   "Stationary neighbour loses patience and jumps in ahead of us from nought.",
#:   "Lorry stops one lane over, sits there, then lunges out before you.",
#:   "Parked up in the next line of cars, then wham, out he comes",
#:   "Scooter pulls up in its lane, bides a while, then swings in front.",
#:   "In the neighbour lane he stops, makes little pause, then drives out before us.",
#:   "Let the ambulance halt in the lane beside the ego's, stay put for a few moments and then break out of the line ahead of it.",
#:   "The minicab had come to rest ahead in the next lane, seemingly content, until it poked out of the tailback before us.",
#:   "V2 ceased moving in the lane adjacent to that of V1, dwelt there, and subsequently set off at an angle into V1's lane immediately in front.",
#:   "That motorbike in the other lane has pulled up behind the queue; give him a second and, there, he's setting off straight into your lane.",
#:   "Nobody expects it: a van that has been standing nose to tail in the other lane for some time abandons its spot and slides over ahead of our car.",
#:   "The test truck shall decelerate to zero in the neighbouring lane, hold position until the subject vehicle is close, and then launch into the latter's lane.",
#:   "I noticed the pickup ahead in the lane to my left because it was braking for the jam. It stood there long enough for me to forget about it, and when I was a few lengths off, the driver swung out into my lane.",
#:   "The queue beside us wasn't going anywhere and you could see he knew it. He'd stopped with the rest of them, drummed on the wheel for a bit, and just as the robotaxi came up he heaved himself out of the line into our way.",
#:   "As a trucker I see this at every roadworks. Somebody halts in the shut lane, has a think about it, and then, when you're nearly level and fully loaded, he pulls across from a dead stand and expects you to find the brakes.",
#:   "The police car had been slowing in the other lane and finally stood still with its hazard lights ticking. She took it for a breakdown; but after a pause the front wheels turned, and it rolled out into the lane in front of her.",
#:   "Request for the simulator: one lane over and somewhat ahead, a car comes to a standstill because its lane is jammed. It remains there until we are nearly on it. Then it leaves the line and gets in front of us, starting from zero.",
#:   "Queue next door; van halts in it, dwells, breaks out before us.",
#:   "Stood there ages, that cab, then jumped lanes from rest into ours.",
#:   "Ambulance pulls up one lane over, bides, then emerges in our path.",
#:   "A biker had put his feet down at the end of the neighbouring queue; a little later he had evidently had enough, for he set off into our lane.",
#:   "The target decelerates to zero in the lane adjacent, dwells until the VUT's headway falls below threshold, and then departs from standstill into the VUT's lane ahead of it.",
#:   "Mum, that car had stopped in the other line and it was sleeping, and when we nearly got there it woke up and came into ours!",
#:   "He braked down in the blocked lane and was standing quite still, I was already thinking of supper, when out he came before me with his wheel at full lock.",
#:   "Simulate a pickup that halts behind a jam beside the ego's lane, sits it out briefly and then escapes into the ego's lane just ahead of it.",
#:   "V2 was brought to a halt in the right lane, remained stationary for an undetermined period and subsequently accelerated into the center lane, directly forward of V1.",
#:   "Lane one had packed up completely by the services. I was still moving in lane two, watching the faces, and there was this one lorry I'd seen come to rest ahead of me; his front wheels were already pointing my way while he waited, and sure enough, when I got close he heaved the lot out.",
#:   "We were lucky with our lane, it was flowing. In the other, a taxi came to a halt behind the dustcart, and you could see the fare leaning forward to argue. By the time we were nearly up to it the argument had been won, because it launched itself into the space in front of us.",
#:   "The statement of the witness is that the squad car had pulled up at the tail of the line like everybody else, its brake lamps burning steadily for some moments. Those lamps went out; the car came round at an angle, and the claimant found it in her own lane.",
#:   "Stationary traffic isn't safe traffic, I tell them. Look along that queue to your right: the chap in the Honda has come to a standstill, and he's been sat there fidgeting, and here we go, he's coming out of it from nothing and he's in front of you.",
#:   "From where I was, filtering on my pushbike, I'd seen her stop with the others and put her handbrake on. It must have been ten seconds before she lost heart and pulled the Clio out of the line, straight into the lane where the grey car was coming along at forty.",
#:   "Edge case for the merge predictor. Neighbour's speed trace goes from sixteen to zero and stays flat there, so we tag it as queued; then, with us a dozen metres short of it, the yaw rate wakes up and we have an agent doing two metres a second in our lane.",
#:   "My husband blames the radio, I blame the man in the camper. He had stopped ahead of us in the next lane where nothing moved, and he looked so settled, with his elbow on the sill. It was only when our bonnet was nearly at his bumper that he let in the clutch and barged into our road.",
#:   "Bei uns the cars make a zip, one and one. This driver made no zip. He has stopped on his lane, has waited until I was shortly behind him on the other one, and then from zero he has pushed himself out before my car.",
#:   "You could call it impatience with a delay. The motorcyclist had braked to a stand behind the buses and, for a slow count of five, he really did stay put; but as the robotaxi drew near he kicked off and swung out of the file into its lane.",
#:   "There's a good bit at 0:42. Watch the white van ahead in the left queue: brake lights, stopped, you forget about it while I talk about the weather, and then it rears out from a dead standstill and I say something the missus told me to bleep.",
#:   "We hit nothing, but only because I had my foot hovering. Something about the way the tanker had settled at the end of the closed lane, wheels turned and engine ticking over, told me that it wouldn't rest there, and when I was nearly level it lumbered out and took my lane.",
#:   "Stationary in the jam, he bided; then our lane had him in it.",
#:   "Next lane's lorry: wheels still, wheels still, wheels turned, out before us.",
#:   "Halted one lane over, cooled his heels, then came out ahead from nothing.",
#:   "The bike stood with both boots down at the tail of the blocked lane, let us get near, and then was away from rest into the strip before our bonnet.",
#:   "I watched its speedometer, so to speak: from forty down to nought in its own lane, nought for a while, and then off at a slant into ours.",
#:   "Program a fire engine to come to rest up ahead in the lane alongside, remain so until the AV is nearly there, and then start from zero into the AV's path.",
#:   "When the brake lamps of that van in the closed lane go out after such a long time, and its front wheels point at you, you know whose lane it's about to be in.",
#:   "V3, having come to a full halt in lane 1 behind queued vehicles and remained at rest for several seconds, started up and entered lane 2 ahead of V1.",
#:   "There stood a taxi in the other row who had braked to zero before and made a long face, and just as I arrive he escapes from there in front of me.",
#:   "His hazard lamps had gone on as his lane clogged up, that was a hundred metres before I reached him. They were still on when he was only a van that I was going to drive past. And they were still on, blinking at me from three metres, when he'd come out of that lane into mine from a dead stand.",
#:   "Nothing was happening in the right-hand lane and that's why nobody was looking at it. A pickup had run up to the end of it and ceased to roll; its driver had time to light a cigarette. The match, I think, was still burning when he gave up on the queue and took the piece of road we were about to cover.",
#:   "What puzzled us in the data is the pause. The neighbour's wheels lock at t = 0, its speed is zero at t = 2 and remains so for a good five seconds. Not until our bumper is twelve metres from his does anything happen, and what happens is that he fills our lane.",
#:   "You'd have thought we'd be safe from the ones that aren't moving. That ambulance in the next line had pulled up, it wasn't on a job, the lad inside was eating his sandwich. Sandwich gone, we're coming level, and out it swings from a cold start, so I had to put the tram driver's brake on, as it were.",
#:   "The bus queue saw it all. First the coupé came gliding up to the roadworks and settled at the end of the line. It waited there, engine muttering. Then a small car drew near in the free lane, and it was as though that had woken the coupé, for it leapt out of the line and into the small car's way.",
#:   "In my statement of the 4th I wrote that the lorry \"suddenly appeared\". To be exact, I had seen it well beforehand, slowing and then standing in the lane next to ours because of the burst main. It was its ceasing to stand that was sudden; it came from nothing into my lane when I was almost at its tail.",
#:   "Never mind the moving ones, I told him, mind the parked-looking ones. That moped over there in the dead lane came to a stop ages ago, and the boy has looked over his shoulder twice. Third time he'll go, third time is now, and he's wobbling off from a standstill right in front of you.",
#:   "It had the look of a car that was there for the day. There'd been brake lights, and then there had been only a car, with others in front of it and behind it, going nowhere. We were doing thirty in the lane that still worked. At the last moment that worked lane of ours contained it.",
#:   "As a lorry driver I blame the signs. They tell you at two miles, at one, and they still run up to the cones. Chap in a Merc ran up, stopped dead, sat there drumming his fingers, let half a dozen of us go through, and then he'd had his fill and came out under my nose from nil.",
#:   "The robotaxi braked at 10:14:36 for a vehicle that at 10:14:34 had a velocity of zero. It had been slowing in the left-hand queue since :21 and stationary since :25. Its first movement after that long rest was out of the queue, into the lane and the path of the robotaxi.",
#:   "We are going in moving lane, other lane is full jam. One Swift car there he put brake, stood, waited two-three minutes it felt, looking at us with sad eyes. Then patience over. When my car is just coming to his side he came out from line, zero to my front, and I shouted his whole family.",
#: ]
#: adversaries = ["car", "truck", "motorcycle", "emergency-vehicle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["stop", "hesitate", "cut-in"]
#: leader = false
#: maneuver = "straight"
#: position = "ahead-beside"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 15.0
#: high = 35.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.6
#: high = 0.9
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 12.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far ahead of the ego it still is when it pulls out"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 7.5
#: unit = "m/s"
#: meaning = "how fast it pulls out"

param OPT_ADV_DISTANCE = Range(15, 35)
param OPT_BRAKE = Range(0.6, 0.9)
param OPT_ADV_AHEAD = Range(12, 30)
param OPT_ADV_SPEED = Range(4, 7.5)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, 24, 16, 4) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and headway(egoRoute, ego, self) > 16
    do BrakeOnPath(advLane, globalParameters.OPT_BRAKE) until self.pose[3] < 0.05
    do Halt() for 0.5 seconds
    do Halt() until headway(advLane, ego, self) < globalParameters.OPT_ADV_AHEAD
    do DrivePath(egoRoute, globalParameters.OPT_ADV_SPEED)
