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
