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
