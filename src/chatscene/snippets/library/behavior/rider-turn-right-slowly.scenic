#: description = "The rider ahead slows down almost to walking pace and turns off to the right."
#: rephrasings = [
#:   "The bike in front slows right down and creeps off to the right.",
#:   "The bicyclist slowed and turned right into a driveway ahead of Vehicle 1.",
#:   "bike ahead slows, turns off right",
#:   "The target ahead reduces its speed and leaves the VUT's lane by a right turn.",
#:   "The cyclist before us becomes very slow and goes right.",
#:   "A postwoman on her bicycle dawdles and makes for a gate on the nearside.",
#:   "The moped we follow all but stops and then bears off right.",
#:   "The delivery rider ahead eases off and turns into a yard.",
#:   "The girl on the bike in front dropped almost to nothing and turned off down a side street on the right.",
#:   "The bicyclist ahead reduced speed considerably and made a right turn off the roadway.",
#:   "MC ahead slows way down, off to R.",
#:   "The leading two-wheeler decelerates to near walking speed and leaves the road by a right turn.",
#:   "The bicycle before me becomes very slow and goes away to the right.",
#:   "Lead rider: decel to ~5 km/h then exits right; blocks us only while turning.",
#:   "He let the bike run down until it could scarcely stand up and then steered it off to the right.",
#:   "Motorbike ahead's looking for his turning, he's right down to a crawl, and there he goes, off to the right.",
#:   "scooter in front went super slow and turned right, finally",
#:   "The cyclist ahead dropped to a crawl and left by a turning on the right.",
#:   "He abated his speed until he was barely moving and then departed to the right.",
#:   "Front bike became very slow, almost walking, and then went inside right side lane.",
#:   "Slows up till he's nearly going backwards, then finally clears off to the right.",
#:   "Pronounced speed reduction of preceding two-wheeler ahead of right turn-off",
#:   "BIKE ALMOST STOPS, THEN TURNS RIGHT",
#:   "The cyclist in front dwindles to a crawl and ducks off right.",
#:   "Scooter ahead fades to footpace, then peels away rightwards.",
#:   "Let the leading cyclist ease nearly to a halt and take a right.",
#:   "Lead bike bleeding speed to jogging rate, exits on our right side",
#:   "The bicycle in front is going so slow like walking, then right side gone.",
#:   "Postie in front dropped to snail speed and right-handed into somebody's drive.",
#:   "The old boy on the pushbike in front of me let his speed run off till he was hardly pedalling, then steered himself away into a lane on the right.",
#:   "The preceding PTW brakes to about 5 km/h in the lane of the vehicle under test and departs from it by way of a right-hand turn.",
#:   "We were following a learner on a moped who slowed and slowed, feet dangling, until at last she tipped into the turning on our right-hand side.",
#:   "V2, a motorcycle traveling ahead of V1, reduced to approximately walking speed before negotiating a right turn out of the roadway.",
#:   "Before me the cyclist made himself very slow, I could have walked with him, and after this he went in the small street at the right.",
#:   "Could you put a rider in front of the robotaxi who loses nearly all his pace and then bears away to the right, still dawdling?",
#:   "She rang me afterwards quite cross about it. The lad on the bike in front of her had braked down until a toddler could have kept up, and at that same pace he rounded the corner to the right and went off between the houses.",
#:   "Watch the delivery rider ahead of us. He's looking at door numbers, so he'll slow, and there you are, he's at a stroll; now he's leaning to the right and he's off into that courtyard, so you can have your speed back.",
#:   "The motorcycle had led our little column for some miles. Near the mill its rider throttled down until the engine almost stalled, and then, unhurried, he guided it through the gap in the wall on his right and was lost to view.",
#:   "Use case: a two-wheeler travels in the ego's lane in front of it. It sheds speed to little more than a walk, which obliges the ego to follow suit, and then it swings off to the right at that same low speed, freeing the lane.",
#:   "Bike and me go way back, so no hard feelings, but I was in a loaded HGV. This fella in front on his racer comes right down to a walk, no arm out, and only then does he veer off into the farm track on our right.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["slow", "turn-right"]
#: position = "ahead"
#: leader = false
#: place = "road"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.6
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 18.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 0.7
#: high = 1.4
#: unit = "m/s"
#: meaning = "how fast it turns"
#: [[parameters]]
#: name = "OPT_TURN_RADIUS"
#: low = 3.0
#: high = 5.0
#: unit = "m"
#: meaning = "the radius of its turn"

param OPT_BRAKE = Range(0.6, 1)
param OPT_ADV_DISTANCE = Range(0, 18)
param OPT_SLOW_SPEED = Range(0.7, 1.4)
param OPT_TURN_RADIUS = Range(3, 5)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego, 4) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < globalParameters.OPT_SLOW_SPEED
    do TurnOff(-1.5, globalParameters.OPT_SLOW_SPEED, globalParameters.OPT_TURN_RADIUS)
    do MoveAhead(globalParameters.OPT_SLOW_SPEED)
