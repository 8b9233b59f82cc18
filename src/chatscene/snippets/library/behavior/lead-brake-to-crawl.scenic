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
