#: description = "The rider shoots out from the side and races across the road, faster and faster."
#: rephrasings = [
#:   "A motorbike comes tearing out of the side and flies over the road in front of us.",
#:   "The motorcycle entered the roadway at an increasing rate of speed and crossed the path of Vehicle 1.",
#:   "moto darts across, full throttle",
#:   "The powered two-wheeler crosses the VUT's path under continuous acceleration.",
#:   "The bike drives over the street with full gas.",
#:   "A downhill racer pedals flat out from one pavement to the other.",
#:   "The moped screams over the carriageway, engine howling.",
#:   "Some kid on an e-bike goes hell for leather from kerb to kerb.",
#:   "A kid on a BMX came rocketing out of nowhere and tore over the road, getting quicker all the way.",
#:   "The bicyclist emerged from the side and crossed the roadway at an increasing rate of speed.",
#:   "MC out from side, straight over, still accelerating.",
#:   "The two-wheeler emerges laterally and crosses the lane of the test vehicle with continuous acceleration.",
#:   "A bicycle comes out very fast and goes over the street, always more fast.",
#:   "Crossing rider, speed ramps up during the crossing, no pause.",
#:   "She burst out between the hedges and flew over the road, pedalling harder with every turn.",
#:   "Dirt bike coming out from the side, he's gunning it straight over, don't try to beat him.",
#:   "kid on a bike flew out from the side n was still speeding up going across",
#:   "A young cyclist came hurtling from a gap and sped over the street, gathering pace all the while.",
#:   "The rider issued from the side, and so far from slowing, he went over the highway ever quicker.",
#:   "Suddenly one cycle came out from side and crossed with more and more speed.",
#:   "Out of nowhere like a cork from a bottle, and pedalling harder the further over he gets.",
#:   "Accelerating lateral dash of two-wheeler from roadside through own lane",
#:   "BMX KID FIRES ACROSS THE ROAD",
#:   "The moped whizzes out and over, gaining pace.",
#:   "Moped out of the alley, straight over, speed climbing all the way.",
#:   "Give me a bike bursting from the verge and accelerating to the far kerb.",
#:   "She flew across from the side, big sister, pedalling quicker and quicker and quicker!",
#:   "Desde el lado comes one moto, crosses, each metre more rapid.",
#:   "Dirt biker zips out sideways, opens it up, gone over before I blinked.",
#:   "Out from behind the hedge popped a lass on a racer, and she was picking up speed with every yard of road until she'd vanished down the opposite bridleway.",
#:   "Two-wheeler laterally released at trigger distance; traverses the roadway in one continuous motion under sustained positive acceleration; no speed reduction within the VUT's lane.",
#:   "By the time he reached the other pavement that lad on the scooter must have been doing thirty, though he'd only been rolling when he emerged beside us.",
#:   "V2, a motorcycle, launched from a field entrance on the right and gained velocity over the entire width of the highway, exiting on the left shoulder.",
#:   "Had the cyclist held back for even an instant we'd have met; as it was, he spurted from the side and rode ever harder to the far edge.",
#:   "A good rider would wait at that gap; this one's catapulted herself into the road and is winding it on and on as she goes over.",
#:   "I was in the passenger seat of the cab when a boy on an electric bike sprang out of a passage between the shops. He didn't look, he simply kept the throttle open, and you could hear the motor whine higher and higher as he crossed both lanes to the park gates opposite.",
#:   "The claimant's vehicle had almost reached the bridge. At this point a motorcyclist emerged from the footpath at its side and proceeded over the carriageway. Far from shutting off, he was speeding up continuously during the crossing, as the rising note of the exhaust on the recording confirms, until he was clear of the road.",
#:   "What I'm after is a bold rider at the roadside. They set off as the AV nears, charge out at right angles to us, and carry on building speed the whole way over, so anyone extrapolating their first half-second will get the arrival time badly wrong. No braking or foot down in the middle.",
#:   "We lorry drivers talk about the bike boys at that crossing place. Yesterday it was two wheels and a pizza box that came whizzing out from between parked vehicles on my nearside, and rather than think twice he leaned on the gas, more, more, more, until he was across and up the opposite ramp.",
#:   "It all took perhaps two seconds. From the shadow of the barn a bicycle shot forth; its rider, head low, legs blurring, was swifter at the ditch on this side than she'd been at the gate, swifter in the middle of the road than at the ditch, and swiftest of all as the far lane swallowed her.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "accelerate", "follow"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 7.0
#: high = 12.0
#: unit = "m/s"
#: meaning = "how fast it wants to ride"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -2.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"

param OPT_ADV_SPEED = Range(7, 12)
param OPT_ADV_DISTANCE = Range(-2, 20)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
