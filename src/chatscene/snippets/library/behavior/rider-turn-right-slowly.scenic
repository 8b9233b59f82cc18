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
