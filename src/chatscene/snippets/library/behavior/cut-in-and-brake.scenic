#: description = "The car cuts in right before the ego and brakes."
#: rephrasings = [
#:   "A vehicle swerves from the next lane into the ego's and decelerates hard.",
#:   "The adversary squeezes in ahead and immediately hits the brakes.",
#:   "The neighbouring car changes lanes in front of the ego and slows sharply.",
#:   "An aggressive driver dives in before the bonnet and brake-checks.",
#:   "The motorcyclist slips in from beside and brakes without warning.",
#:   "He cuts us up and stamps on the anchors.",
#:   "Vehicle 2 changed lanes immediately ahead of vehicle 1 and braked heavily.",
#:   "The target performs a cut-in followed by full deceleration in front of the VUT.",
#:   "Some muppet nipped in front of me and straight away jumped on the anchors.",
#:   "Unit 2 made an unsafe lane change immediately ahead of Unit 1 and applied its brakes.",
#:   "Truck squeezes in from next lane, slams brakes.",
#:   "The target vehicle changes lane with minimal clearance ahead of the test vehicle and decelerates at once.",
#:   "A car comes in my lane very near before me and brakes strong.",
#:   "Actor merges at tiny gap then decelerates hard; we need AEB right after the lane change.",
#:   "He had barely finished shoving in ahead of her when his brake lights came on.",
#:   "The biker's going to chop in on you, leave room, there he goes and he's on his brakes already.",
#:   "guy swooped in front of me and slammed em instantly i almost died",
#:   "A lorry barged in ahead of the hatchback and slowed violently, leaving its driver little time to react.",
#:   "Having inserted himself into the space before my client, the defendant forthwith retarded his vehicle.",
#:   "This cab anyhow squeeze in then straightaway e-brake, my heart almost drop.",
#:   "Shoves his nose in where there's no room and then lights up his brake lamps for a thank you.",
#:   "Close-range lane entry by neighbouring vehicle with immediate harsh deceleration",
#:   "INSURANCE SCAM? Swoops in and BRAKE CHECKS me",
#:   "The van wedges itself ahead of us and bites down on its discs.",
#:   "Bus muscles in ahead of us and its brake lights blaze. Nasty.",
#:   "Trickster on a moped: slots in under your nose, yanks the lever.",
#:   "Let a truck change lane tight before the ego, then retard hard.",
#:   "He come in my lane, no space, and then pum, full brake.",
#:   "The AV's lane was taken by a coupé which then promptly stood on it",
#:   "The vehicle alongside slid over into the sliver of room before my bonnet and, before I could so much as swear, was scrubbing off its speed.",
#:   "A claim is made in respect of damage to crockery in transit, the neighbouring pickup having pushed in close ahead and then shed most of its speed in an instant.",
#:   "Why would anybody wriggle in between me and the car in front, with a whole empty road to choose from, and then go hard for the middle pedal?",
#:   "Sequence: (1) truck in adjacent lane encroaches and completes lane change at 5 m headway; (2) upon centring in lane, it sheds speed at 6 m/s².",
#:   "\"She changed into our lane right at our bumper and then everything lit up red in front of me,\" the coach passenger recalled, still trembling, in her statement.",
#:   "If someone dives into your safety gap like that bike's just done, drop back, because look, they very often anchor up straight afterwards, exactly as he's doing.",
#:   "My grandson was driving me to the clinic. A big lorry that had been keeping us company in the other lane suddenly decided it wanted ours, came in so close I could have touched it, and then would you believe it put its brakes on with a great hiss.",
#:   "Posting this for anyone who thinks gaps are safe. I leave two car lengths, guy in a white BMW next to me treats it as an invitation, cuts into it with no signal and then immediately hauls his speed down like he's spotted a camera. ABS saved my bacon.",
#:   "The robotaxi was cruising in the left lane when a motorcycle from the neighbouring lane tucked itself in at roughly three metres. Barely had it settled in front when its rider squeezed hard, and the closing speed jumped from nothing to something our system classed as critical.",
#:   "In the lorry you see it coming a mile off. He creeps up next to the tractor unit, looks in his mirror, shoves across with a whisker to spare, and then, I suppose because his mate's turning was coming up, he's digging his heels in and I'm braking thirty-eight tonnes.",
#:   "We had a vehicle at our side, a city bus, the whole way down the hill. It moved over right before our nose, in one quick motion, and straight after that it braked with such force that I saw the standing passengers being flung forward.",
#:   "Sideswiped of my gap by a van, then greeted by red lamps.",
#:   "Coach out of its lane into ours, tight, and braking. Heads up.",
#:   "he merged basically INTO me n hit the brakes lol",
#:   "From the lane alongside, a motorcyclist took the metre and a half that was mine and, once he had it, clamped down on both levers.",
#:   "Two actions, no pause between: adjacent lorry appropriates the space ahead of the subject vehicle; adjacent lorry, now the lead vehicle, retards strongly.",
#:   "Ihr Bus jumps from the other lane in my lane, direct before me, and then he makes the brake so strong that my coffee flies.",
#:   "The complaint against the cabman is that, having come over into the witness's lane with inches in hand, he there and then threw out his anchors.",
#:   "There's a chap at your side getting twitchy, so ease off. Told you: into your gap like a cork in a bottle, and now he's hauling himself down.",
#:   "Let a pickup leave the neighbouring lane for ours at almost no distance and, the moment its wheels are straight, have it decelerate as hard as it can.",
#:   "I keep a proper following distance because I was taught to, and this is what it gets me. Some estate car in the next lane reckoned the hole was meant for him. No sooner was his tail in front of my bumper than it rose in the air, the way tails do when the front wheels are biting.",
#:   "All I saw for a second was the advertisement on the side of a bus, sliding from left to right across the windscreen. Then I saw the back of the bus. Then I saw that the back of the bus was lit up like a Christmas tree and getting bigger, and that's when I swerved into the hedge.",
#:   "V1 was travelling in the right lane at 58 mph. V2, in the left lane, merged into V1's lane leaving a space of about eight feet. According to V1's forward radar the merged vehicle then shed 20 mph in little over a second. V1's collision mitigation system intervened and nobody was injured.",
#:   "The egg farm will bear me out about my usual care. On the date in question the truck running parallel to me on the dual carriageway moved across my front without the least room for it, and its air brakes came on with a bang almost before the trailer had finished following. I lost thirty dozen.",
#:   "So the safety driver's notes say \"rude van\". Here's what rude van did. It sits in the next lane, fine. It takes our lane with a gap of 0.3 seconds, less fine. And then our distance should open again, since that's what normally happens, but instead it collapses, because rude van is on the middle pedal.",
#:   "My daughter was practising with me for her test. I had just told her that other people do not always look. The scooter which was in the lane at our side, he put himself before our bumper, tac, like a thread in a needle, and in the same second his red light shines and he is almost standing.",
#:   "On two wheels one learns to look at people's front tyres. I was pedalling along the cycle path and saw the tyres of the SUV turn towards the other lane, where a little blue car was already. In it went, a hair's breadth before the blue nose. And then came the screech, and it was the SUV's, not the blue car's.",
#:   "It had been a friendly sort of drive until the coach. The coach had grown tired of its own lane and wished for Harriet's; it leaned over, filled her whole view with its back windows, on which schoolchildren were pulling faces, and then all the faces lurched away from her at once and the brake lamps glared.",
#:   "Why do they do it? He'd got a whole clear lane of his own, that motorcyclist. Yet he drops into the bit of space in front of my grille, where I can't hardly see him over the dash, and chops his speed. Thirty-eight tonnes, I've got. I stood that lorry on its nose for him.",
#:   "Caller states she is shaken but unhurt. A silver people carrier switched from the lane next to hers so sharply and so near that she had already taken her foot off; a good thing, she says, as it promptly braked right there in front of her, and she finished up with her bonnet under its tow bar.",
#:   "Operator's guide, section 6: aggressive merging. Select the vehicle at the ego's side. Lower the merge gap until the two outlines almost touch in the top view. Tick \"retard after merge\", and set it to strong, so that the pressure doesn't end with the lane change but gets worse from that moment on.",
#:   "Lane-thief bus: takes my gap, then takes my speed.",
#:   "Van from beside, slotted in tight, nose down, lamps lit. Grim.",
#:   "he came over into my gap n his whole back end went red",
#:   "The gap I had kept for emergencies was suddenly occupied by a neighbour's pickup, and the emergency, it turned out, was that same pickup shedding all its speed.",
#:   "First there was the blink of his indicator level with my door, then his bumper where my gap had been, and already that bumper was rushing backwards at me.",
#:   "Out of the next lane and into ours with barely a bonnet's length, the scooter sat up, its rear wheel hopping from the force on its front disc.",
#:   "Two headways to log for the lorry: 0.5 s when it completes its move from the adjacent lane into ours, and 0.2 s a moment later owing to its own deceleration.",
#:   "Never mind that she took my space from the lane alongside; it's that I had to go from sixty to twenty behind her, because she'd done so first.",
#:   "In the middle of my sentence the coach that had been beside us was in front of us, much too near, with its tail going down in speed like a lift.",
#:   "My laptop is in pieces and I'd like somebody to pay for it. It was on the seat, and it went into the dashboard because I had to stop dead. I had to stop dead because the grey van in the lane next to mine decided my lane was nicer, came over with nothing to spare, and there, with the road clear before it, hauled itself down to a crawl.",
#:   "Let us take the video a frame at a time. Here you see the truck's front wheel beginning to turn towards our line; it is still our neighbour. Twenty frames on, its mudflaps are over our bonnet badge. Now the two red squares come on and the mudflaps swing forward, and you notice that the chassis is no longer getting away from us, quite the opposite.",
#:   "As a trucker I can tell you a trailer needs eighty metres, and I'd left eighty. Those eighty were up for grabs, seemingly. A little city car that had been whirring along under my left window whipped over into the last ten of them, straight under the bumper. I could have forgiven it that. But then I saw its tail rise and its lamps flare.",
#:   "What did you feel? I asked the pupil afterwards. She said first a sort of shadow coming from the side, and that was the motorbike leaving his lane for ours. Then she said it was as if he was being reeled in towards us on a string. Quite right. He'd pulled the lever. We weren't speeding up, he was slowing down.",
#:   "Requirement 9.4: the system shall cope with a loss of headway in two steps. In step one the vehicle that has been travelling at our side occupies our lane, leaving no more than six metres. In step two, following without a rest, that vehicle's speed is reduced at seven metres per second squared. The ego did nothing to deserve either.",
#:   "A smell of rubber, a horn that turned out to be mine, and the words How's My Driving about an arm's length off. I'd been watching the sheep. The bus those words were painted on had been in the other lane when I began watching the sheep. It seems it had wanted my bit of road only in order to come to a near standstill on it.",
#:   "The dispatcher played the tape. \"He's alongside me. He's alongside me, he's looking over. Oh, he's in, he's right in front, there's no room.\" A thump of things falling. \"He's slowing down! What's he slowing down for? There's nothing there, there's nothing there in front of him!\" After that you could only hear the brakes, hers, and the woman breathing.",
#:   "Mein Fahrlehrer has said the distance is your life insurance. I have paid this insurance every day. Today comes from the neighbour lane a sports car and sits down in my distance, so close that I can't read the plate, and as he is sitting there he throws the anchor. From my insurance was then left perhaps one metre.",
#:   "I ride pillion, so I see more than my husband does. On our left there was a minicab, its driver eating. It came across to us as a drawer closes, all the way in till it filled our lane, and I thought, he'll drive on now. But the helmet in front of me knocked against mine. The minicab had put its tail lights practically in our forks and was dropping to nothing.",
#:   "It has come to our notice that the automated shuttle spilled eleven passengers on the floor at Mill Lane. The log exonerates it. A tanker, until then abreast of the shuttle, had taken possession of the lane at a distance no human would call decent, and had, with its whole rear axle juddering, thrown away two thirds of its speed inside the next two seconds.",
#:   "She knew how it must have looked: a rear-end collision, and she the one behind. But nobody had been in front of her when the song began; there had been a man in a jeep at her side. By the chorus he'd wrenched himself over into the strip of road ahead of her, near enough to touch, and it was then that the jeep's weight had pitched on to its front wheels.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["cut-in", "brake"]
#: leader = false
#: blocker = false
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -15.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it drives while it cuts in"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.4
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_DISTANCE = Range(-15, 20)
param OPT_ADV_SPEED = Range(5, 9)
param OPT_BRAKE = Range(0.4, 1)

behavior AdvBehavior():
    do KeepStation(advLane, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(ownLane(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(ownLane(egoRoute), self)) < 1
    do BrakeOnPath(ownLane(egoRoute), globalParameters.OPT_BRAKE)
