#: description = "The car ahead brakes hard and then creeps on at walking pace."
#: rephrasings = [
#:   "He hits the brakes in front of us and then just crawls along.",
#:   "Vehicle 1 decelerated abruptly and proceeded at a very low rate of travel.",
#:   "Lead veh hard decel to approx 5 km/h, continues.",
#:   "The target brakes strongly to a residual low speed before the VUT.",
#:   "The car in front is braking heavy and after it goes like a turtle.",
#:   "The bus ahead of us anchors up, then inches forward.",
#:   "A lorry in our lane dives on its nose and afterwards dawdles on.",
#:   "Sharp braking from the leader followed by a tedious creep.",
#:   "The car in front stood on the brakes for no reason and then dawdled along at a snail's pace.",
#:   "The lead vehicle braked sharply and then continued at approximately 3 mph.",
#:   "Bus ahead, hard brake, then inching fwd, no stop.",
#:   "The lead vehicle decelerates strongly to approximately 5 km/h and maintains that speed.",
#:   "Motorbike before me brakes strong and after that drives so slow like a man walks.",
#:   "Lead: heavy decel to a crawl, never reaches zero, stays there.",
#:   "He slammed his brakes, but did not stop; he crept on like a hearse and she crept after him.",
#:   "Brakes on in front, hard, he hasn't stopped though, he's just tiptoeing along now.",
#:   "he braked mega hard and now hes going like 3mph im gonna cry",
#:   "The leading car shed its speed in an instant and thereafter trickled along no faster than a stroller.",
#:   "He did not stop, my lord; he threw off nearly all his speed and went forward at the gait of a man on foot.",
#:   "Front bus suddenly jam brake, then go at tortoise speed, not stopping also.",
#:   "Anchors on, I nearly eat his bumper, and then he won't stop and he won't go, just trickles along like a funeral.",
#:   "Harsh deceleration of preceding vehicle down to residual walking speed without standstill",
#:   "BRAKES HARD... then drives slower than I WALK",
#:   "The lorry in front sheds its speed and oozes onward.",
#:   "Leader bins its speed at once, then ambles, never stopping.",
#:   "Van before us stamps on it, then moves at shuffling pace.",
#:   "Hard brake by the cab in front, then pram-pushing speed.",
#:   "Make the coach ahead brake sharply but keep rolling, barely.",
#:   "Fire engine ahead drops from fifty to next to nothing, then plods.",
#:   "All at once the pickup's brake lights blazed, and the next thing I knew we were both going along no quicker than pedestrians.",
#:   "The motorcyclist in front of the robotaxi scrubbed off nearly everything in two seconds and then balanced along at a wobbling crawl.",
#:   "Firstly the truck before me is braking like for an accident, then he doesn't stand, he goes further with five kilometres in the hour.",
#:   "Final speed of the preceding vehicle shall be 1.5 m/s, reached by emergency-type deceleration and kept until the end of the test.",
#:   "What's she playing at up front, hauling it down that violently only to tootle on as if she were counting daisies?",
#:   "There was a bang of brakes from the bus ahead; it never came to a stand, though, it just kept trickling up the road.",
#:   "We were trailing a hearse-black saloon down the high street when it braked fit to throw the driver through the glass. It did not halt, mind, it simply dragged itself along from then on, a yard at a time, and we behind it.",
#:   "The operator of V1 reported that the ambulance directly ahead decelerated without warning. It remained in motion, however, at approximately the pace of a person walking, and the operator, expecting a complete stop or a recovery, misjudged the gap.",
#:   "Two parts to this one, so listen. The lorry in front brakes fiercely, and you must too; but then he carries on rolling at a snail's trot, so you've got to drop in behind and have patience, not blast the horn.",
#:   "Hi all, I have question. Today front car suddenly pressed brake so hard that my phone flew off, after that he was driving on slow slow like ox cart. Why would the autopilot first panic and then jerk all the way?",
#:   "The motorhome in front had found its campsite sign. Down went its bonnet, my coffee went everywhere, and instead of stopping it oozed along the lane with the wife leaning out of the window reading every gatepost.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["brake", "slow"]
#: position = "ahead"
#: leader = false
#: blocker = false
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -15.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.45
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.0
#: high = 3.0
#: unit = "m/s"
#: meaning = "how fast it creeps on"

param OPT_ADV_DISTANCE = Range(-15, 20)
param OPT_BRAKE = Range(0.45, 1)
param OPT_ADV_SPEED = Range(1, 3)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
