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
