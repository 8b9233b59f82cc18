#: description = "The car noses slowly into the intersection, then dashes across."
#: rephrasings = [
#:   "he edges out bit by bit and then suddenly goes for it",
#:   "Vehicle 2 crept forward into the intersection, then accelerated rapidly across.",
#:   "creeps out, then full gas over",
#:   "The target enters the junction at walking pace and then accelerates strongly across the path of the VUT.",
#:   "The car comes out slowly slowly, and suddenly it jumps forward.",
#:   "A taxi inches forward to see better and then bolts over.",
#:   "The biker rolls out gingerly before opening the throttle wide.",
#:   "First it pokes its bonnet out, then it sprints across.",
#:   "He inched his nose out into the crossroads, bit by bit, then went hell for leather over it.",
#:   "Unit 2 edged slowly into the intersection and then abruptly sped across.",
#:   "Van creeps in, then guns it across.",
#:   "The target vehicle enters the junction at very low speed, then accelerates strongly to clear it.",
#:   "First the car goes slow slow into the crossing, then very fast over.",
#:   "Two-phase actor: sneak into junction at crawl, then punch it.",
#:   "It poked out its snout as though testing the water, and then it made a mad bolt for the other side.",
#:   "See him sneaking out, he's peeping, he's peeping, and now he's made a run for it.",
#:   "he was like slooowly poking out n then BOOM across",
#:   "A van stole into the intersection at a crawl before shooting over to the far side.",
#:   "You ventured out by degrees, sir, and having ventured you then made all haste across?",
#:   "First he is coming little little into junction, then suddenly he ran the car to other side.",
#:   "Sneaks his bonnet out an inch at a time, I slow down for him, then he legs it over anyway.",
#:   "Tentative intersection entry of crossing vehicle followed by rapid clearance",
#:   "CREEP... CREEP... ZOOM! Nearly got him",
#:   "The truck tiptoes into the crossing and then bolts.",
#:   "Pickup peeking out at the crossroads, peeking, then whoosh, straight over.",
#:   "Ambulance: dead-slow entry to the junction, then rapid clearance to far side.",
#:   "I want a rider who sidles into the junction and then blasts over.",
#:   "Zuerst it feels forward into the crossing, after this it sprints over.",
#:   "a bit out, a bit more out, then WHAM floored it across",
#:   "From the side street a lorry stuck its cab out foot by foot, and just when I'd made up my mind to go, it thundered over ahead of me.",
#:   "What are we to make of a driver who slinks into the intersection like a burglar and then leaves it on the other side like a getaway car?",
#:   "The SUV finished its crossing at a furious rate, although it had begun it at barely a trickle, its bumper nudging out past the hedge.",
#:   "Phase one: target advances into the intersection at 1 m/s. Phase two: target applies full throttle and vacates the conflict zone on the opposite side.",
#:   "Let him poke about in the mouth of the junction, he can't see yet. Hang on, he's made his mind up now, he's belting over.",
#:   "V2 protruded gradually into the intersection from a side road before its operator abruptly gave it full power and shot through to the opposite leg.",
#:   "I was on my bicycle, so I read front wheels. This taxi's were turning ever so slowly as it stole past the give-way line into the crossroads, and I thought he'd seen me; then the engine barked and he'd scooted over to the other side in a blink.",
#:   "My client maintains that the fire engine was almost stationary when its cab emerged into the junction. It then, in a complete change of manner, was driven across with great haste, so that the distance which had seemed ample to her was ample no longer.",
#:   "Dash-cam from a reader in Leeds: hatchback comes from the left, the bonnet slides into view, a bit more bonnet, a bit more, painfully timid. And then it's as though somebody's stung the driver, because he simply hurls the thing over the crossroads before the camera car gets there.",
#:   "The ego approaches an ordinary crossroads. A motorcyclist from the cross street should first dribble into it, feet almost down, to see round the parked lorries, and once we are near he should crack the throttle and streak to the far side.",
#:   "Sir, the tempo truck from side road was coming inch, inch, inch only into the junction, so I thought he is giving me way. When I reached near, the driver pressed full race and rushed it to the opposite road.",
#:   "Truck probing the crossroads at a crawl. Now it's charging over.",
#:   "Sneaky start, rocket finish: hatchback clears the junction before us.",
#:   "peek peek peek from the side road then FULL send to the other side",
#:   "The fire engine's cab came into the crossroads a hand's breadth at a time, and it left on the opposite side with its exhaust stack roaring.",
#:   "Crossing agent's speed trace inside the box: a long foot near 1 m/s, then a cliff, up to 11 before the far stop line.",
#:   "Was there not first a bumper, then a wing, then a door coming by slow degrees from the side street, and after that a mad gallop over?",
#:   "When the biker from the lane on the right had felt his way far enough out to see past the van, he dumped the clutch and flew over.",
#:   "Slowly, very slowly, the little white taxi is entering from the side like a mouse, and then like a mouse that saw the cat it runs across.",
#:   "It took V2 six seconds to advance its front axle beyond the edge line and under two to reach the other leg of the intersection.",
#:   "There's a hedge on that corner, so nobody can see anything. What I saw was a number plate. It came out from behind the leaves so timidly I could've read it to you letter by letter. Letter seven never arrived, because the whole lot suddenly shot by in front of us and was away up Mill Road.",
#:   "If he'd gone on as he'd begun I'd have been through before him. He'd been letting the lorry dribble into the junction, a bit and a bit and a bit. But then there was black smoke out of the stack and that great blunt face went right over my side and out at the opposite end, and I went up the kerb.",
#:   "My tutor says to watch the weight of a car. This one, coming out from the side at the crossroads, sat level for ages, wheels only just turning. All of a sudden its tail squatted and its nose came up. I had my foot on the brake before I'd thought about it, and it streaked to the opposite street.",
#:   "Please split the adversary's run in two. Until it's got its front half into the intersection it moves as if on ice, at a speed you'd hardly notice. The moment the AV is committed, it should throw all that caution away and rocket to the far side. A plain fast entry isn't what we're after, nor a pause and a gentle drive-off.",
#:   "The claimant assumed she had been seen. It was a fair assumption: the motorcycle from the side turning was being walked out, almost, with its rider craning round a skip. He had got his wheel well out when, for whatever reason, he gave it everything, and passed before her bumper to the street beyond.",
#:   "Ambulance crew say they were careful, and for half of it they were. I was the cyclist at the lights. They stole into the middle with hardly any movement at all; I took my foot off the ground thinking I could go. Then the engine bellowed, and it was over on the other side with my hair standing on end.",
#:   "Old Petrus had two gaits, like his mules. With the first he brought the pickup's nose out between the gum trees, so stealthily that the dust didn't rise. With the second, once the nose had seen what it wanted, he crossed the highway, and for that one the dust rose to the telegraph wires.",
#:   "Unit 7 to base. We've lost our clear run at Harbour Cross. A box van was nudging out from the right, painfully careful, a bit at a time, so we held our speed. It then accelerated flat out right over our path and into Dock Street. No collision, but the patient isn't best pleased.",
#:   "On the top of the hill there are four roads and no rules. The jeep from the side was slipping itself in like a thief, centimetre after centimetre. I am thinking: good, he is a gentleman, he looks. Then the gentleman pushes the pedal to the floor, and I only see the spare wheel on his back going into the other road.",
#:   "Two frames from the log say it all. In frame 210 the police car is poking its bonnet past the give-way markings at something less than strolling pace. In frame 245, barely a second and a half on, it's beyond our lane on the opposite arm, wheels still spinning. The prediction had it waiting.",
#:   "I'll tell you what did for my tomatoes. You think a car that comes into a crossroads by inches is a car that'll let you pass. Well, this one came by inches as far as the manhole cover. From the manhole cover onwards it came by furlongs, right over to the chapel side, and I had to brake till the boxes flew.",
#:   "Nose, more nose, pause; then whoosh, whole fire engine, gone over.",
#:   "pickup tiptoed out to the middle n then absolutely launched to the other side",
#:   "Truck, cross street: inching in... inching... and he's bolted across. Over.",
#:   "It took the taxi longer to get its front wheels past the kerb line than it did to cover all the remaining four lanes of the crossroads.",
#:   "Timid as a mouse up to the point where our paths meet, the motorbike was off through the junction from there like the cat that was after the mouse.",
#:   "You may be caught by this type, who lets you believe he's only peeping out into the crossroads and, just as you've relaxed, has his foot flat and is over.",
#:   "Phase A: intrusion into the junction at about 1 m/s. Phase B: a brief pause short of the conflict point. Phase C: full throttle through to the far exit.",
#:   "I read the slow bit of tarmac that bonnet was gaining as a sign it would wait, so the roar, when it flung the whole saloon over before me, caught me coasting.",
#:   "Please have the van work its way out into the crossing as if on eggshells and then, with the robotaxi nearly there, fire itself out the other end.",
#:   "There was a bonnet at the corner, and each time I looked there was a little more of it. A headlamp. A wing. A wing mirror. I'd got used to it coming by instalments, like the sofa. The rest of the car, all four doors of it, was then delivered in one go, with wheelspin, from the one side of the junction to the other, under my nose.",
#:   "Officer, he'd fooled us both. The lorry's front bumper had been easing past the give-way for so long that my husband said \"he's seen us, he'll stop\", and he did, for a breath. Then there was black smoke, and a noise like a landslide, and we were looking at the rear doors of it clearing the crossroads on the far side. We'd stopped in the bushes.",
#:   "The engine told the story before the eyes could. First a mutter, hardly above idle, from the left-hand arm of the crossing: that was the biker letting it walk out beneath him. Next to nothing, a held breath. After which a scream that started on the left and ended on the right, and the smell of a hot clutch hung over the whole junction while I restarted mine.",
#:   "The speed plot of the crossing ambulance should look like a hockey stick lying on its blade. A long flat portion, one metre per second, taking it out from the side road and into the square; a dip to zero; then near vertical. If the ego decides on the flat portion that the road will be free, it'll meet the vertical portion with its radiator.",
#:   "In the theory test she got it right, and on the road wrong. I pointed to the hatchback in the mouth of the street on the right and asked what it would do. \"It's edging,\" she said, \"edging in, he's making sure, he stops.\" So she kept on. I had to use my pedals, because all that edging had been a run-up, and the hatchback crossed our bows like a shot.",
#:   "Je vous explique. The camionnette comes out on the crossing as a snail who puts first one horn, then the other. I pass, I say to myself, a snail does not attack. But this snail made just a pause, and he has changed into a rabbit: in one jump he was on the other part, and me, I was across, with my baguettes on my knees.",
#:   "My helmet camera is good for arguments. The van driver says he never rushed. Well, here he is in the junction, thirty seconds in, and the pedestrian with the stick is beating him. Here he is at a stand. And here, one second later by the counter, is the empty place where he stood, and his bumper leaving on the opposite side, and my front wheel in the air.",
#:   "They found her ring, in the end, under the passenger mat. It had come off when she threw up her hands, and she'd thrown them up because that long dark car, which had stolen out so softly into the crossing that she'd pitied the driver for an old woman, had stopped, considered, and then gone before them to the other street in a single howling rush.",
#:   "On approach to the intersection V1's operator observed V2, a box truck, protruding from the right-hand leg. Its protrusion was increasing by roughly a foot per second. V1's operator assumed V2 was improving its sight line, and maintained speed. Rubber deposits nine feet inside the intersection, pointing straight to the opposite leg, show where V2 left off improving it.",
#:   "Why'd you brake so hard, the examiner wants to know. Because a motorcycle at the crossroads had been giving itself a bit more of the road every second without ever properly setting off, and I don't trust that. He might have been a nervous beginner. What he was, it turned out, was a wasp: he hung there, and then he was on the other side, and where he'd hung we'd have been.",
#:   "So it goes in hard mode, chat. Boss is the white SUV. First phase, you'll think it's bugged, it just slides into the crossroads a pixel at a time. Second phase it freezes. Don't go! Everybody goes. Third phase it does the entire rest of the junction in, what, half a second, engine maxed, and you're toast. I've died to it six times now.",
#: ]
#: adversaries = ["car", "truck", "motorcycle", "emergency-vehicle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["hesitate", "accelerate"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 1.5
#: high = 3.0
#: unit = "m/s"
#: meaning = "how fast it noses out"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = -7.0
#: high = -3.5
#: unit = "m"
#: meaning = "how far beyond where their ways meet it pauses"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.3
#: high = 1.0
#: unit = "s"
#: meaning = "how long it pauses before it dashes"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.7
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_DISTANCE = Range(0, 20)
param OPT_SLOW_SPEED = Range(1.5, 3)
param OPT_STOP_DISTANCE = Range(-7, -3.5)
param OPT_STOP_TIME = Range(0.3, 1)
param OPT_THROTTLE = Range(0.7, 1)

advTurn = "straight"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advMeeting) < 12 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_SLOW_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED) until self.pose[3] > 1 and distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory) until self.pose[3] < 0.05
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, 10)
