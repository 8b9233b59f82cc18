#: description = "The car ahead moves in stop-and-go: it halts, rolls a little, halts again."
#: rephrasings = [
#:   "We're stuck behind somebody who stops, rolls a bit, stops again, like in a jam.",
#:   "Vehicle 2 advanced in short movements with a standstill between them, as in congested traffic.",
#:   "Lead vehicle in queue mode: stop, few metres, stop, few metres.",
#:   "The target alternates between standstill and low speed in front of the VUT, traffic jam profile.",
#:   "The car before us goes and stands, goes and stands, all the time.",
#:   "The bus in front creeps up, pauses, creeps up, pauses.",
#:   "Queueing traffic: the taxi ahead keeps nudging forward and halting.",
#:   "Start, halt, start, halt: our leader concertinas along the lane.",
#:   "the one in front kept stopping and rolling on, stopping and rolling on, like it was rush hour on the M25",
#:   "V2, preceding V1, made repeated stops, advancing only a short distance between each one.",
#:   "Bus ahead: halt - inch fwd - halt - inch fwd.",
#:   "The lead vehicle alternates between standstill and short low-speed movements.",
#:   "The truck in front stands, goes two metres, stands again, all the time so.",
#:   "Jam-style lead profile: v=0, creep a few metres, v=0, repeat.",
#:   "The car before her crept forward, stood, crept again and stood again, and there was no end to it.",
#:   "It's crawl a bit and wait, crawl a bit and wait with this motorbike ahead; keep your foot over the brake.",
#:   "car in front keeps stopping then going like 2 metres then stopping again im so carsick",
#:   "A delivery van advanced by fits and starts, stopping every few yards to its followers' fury",
#:   "It stood, it moved a short way, it stood again, and this repeated itself throughout?",
#:   "Front bus stop, move little bit, stop again, move little bit, give me headache",
#:   "Go a yard, stop. Go a yard, stop. I've burnt my clutch out behind this geezer",
#:   "Intermittent motion of lead vehicle with repeated standstills",
#:   "Car ahead moves 3 metres, STOPS, repeat x10",
#:   "The fire engine ahead hiccuped along from halt to halt.",
#:   "Coach ahead shuffles, stands, shuffles, stands; all morning like this",
#:   "Give the ego a leader that stops, trundles a few feet, stops anew, endlessly.",
#:   "The red car in front goes a teeny bit, then no, then a teeny bit.",
#:   "Front moped again and again stopping, then small small moving.",
#:   "Why won't he make up his mind: stand, roll, stand, roll?",
#:   "The ambulance we were following never got going properly; it would come to rest, advance by the length of a parked car and be at rest again.",
#:   "The lead actor's speed trace should be a comb: zero, a brief bump, zero once more, for as long as the scene lasts.",
#:   "I told the constable that the lorry in front had been lurching on a yard or two at a time, with a dead halt after each of those yards.",
#:   "Follow the van through a jam profile, in which standstills of a couple of seconds alternate with short spells of crawling, and see whether the ACC copes.",
#:   "He halts, you halt; he dribbles on a bit, you dribble on a bit, he halts again, and so it'll go, so don't get bored back here.",
#:   "In front of me the motorcyclist puts his feet down, lifts them for some metres, puts them down, lifts them, always the same music.",
#:   "My left knee is not what it was, and this didn't help. The saloon before me kept coming to rest, then it would roll forward as far as a garden gate, then come to rest once more, and I was on the clutch the entire time.",
#:   "V2 was immediately ahead of V1 in heavy congestion. Witnesses describe its progress as a succession of halts separated by rolls of no more than a few metres, and it was during one of the later halts that contact between bumpers occurred.",
#:   "Comment under the video: I can't watch this without feeling sick. The pickup in front stands still, then it nudges up, stands still, nudges up, stands still, and the robotaxi copies each one of those with a little nod of its nose.",
#:   "Nothing in front of the police car explained it, but the police car itself moved like a caterpillar. It would bunch itself up to a halt, stretch forward a little, and halt; and behind it she did likewise, wondering when it would end.",
#:   "We took forty minutes for the last mile into town. The bus ahead set the rhythm: brakes hiss, nothing moves, it eases on maybe ten feet, brakes hiss again, nothing moves. I know every rivet on the back of that thing by now.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "UN R157 traffic jam; own code"
#: [slots]
#: actions = ["stop", "hesitate", "slow"]
#: position = "ahead"
#: leader = false
#: blocker = false
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 2.0
#: high = 28.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.2
#: high = 0.5
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.8
#: high = 2.0
#: unit = "s"
#: meaning = "how long it stands"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.5
#: high = 3.5
#: unit = "m/s"
#: meaning = "how fast it rolls between two halts"

param OPT_ADV_DISTANCE = Range(2, 28)
param OPT_BRAKE = Range(0.2, 0.5)
param OPT_STOP_TIME = Range(0.8, 2)
param OPT_ADV_SPEED = Range(1.5, 3.5)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    while True:
        do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.05
        do Halt() for globalParameters.OPT_STOP_TIME seconds
        do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) for 2.5 seconds
