#: description = "The parked car starts to pull out, stops, hesitates and then pulls out after all."
#: rephrasings = [
#:   "The parked car starts out, stops, dithers, then goes for it right before us.",
#:   "Vehicle 2 began to leave the curb, paused and then entered the travel lane.",
#:   "Parked veh moves, halts, moves again into lane.",
#:   "The target starts from the parking strip, dwells at standstill and then merges ahead of the VUT.",
#:   "It goes a bit, stands a bit, and when we think it waits, it comes out.",
#:   "The bus twitches away from its stop, checks its mirror, and lumbers out anyway.",
#:   "A nervous learner creeps from his space, freezes, and commits too late.",
#:   "The motorcyclist paddles off the roadside, pauses, then pops out.",
#:   "the parked Fiesta edged out, thought twice, sat there dithering, and then came out anyway",
#:   "V2 began to leave the curb, stopped, remained for a moment, and subsequently entered V1's lane.",
#:   "Bus: starts off from stop, halts, dithers, then out after all.",
#:   "The parked target initiates a move-off, interrupts it for several seconds, and then completes its entry into the lane.",
#:   "The parked car comes out a little, stops, does not know, and then it comes out really.",
#:   "Two-phase move-off from the parking bay: creep, pause, then full entry into the ego lane. Timing of the pause tunable.",
#:   "The motorbike had inched off the kerb and baulked, and just when they believed it would stay, it came out.",
#:   "He's not sure whether to leave that space or not: bit out, stop, umm, ahh, and now he's coming after all.",
#:   "parked car was like should i go should i not, then went right in front of us",
#:   "The nervous driver edged from her space, had second thoughts, and finally came out in the face of traffic",
#:   "First he moved, then he waited, and only then did he enter the lane, as you recall it?",
#:   "The bus move out a bit, stop, think think think, then come out after all, confuse people only",
#:   "In or out, love? Nose out, stops, has a ponder, and just when I reckon she's waiting, out she comes",
#:   "Indecisive departure of parked vehicle: partial start, dwell, delayed entry into lane",
#:   "Parked scooter can't decide... then pulls out ANYWAY",
#:   "The parked car twitched, wavered, then slid out.",
#: ]
#: adversaries = ["car", "bus", "motorcycle"]
#: requires = ["advKerb", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["hesitate", "pull-out"]
#: side = "right"
#: position = "kerb"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 24.0
#: high = 42.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.3
#: high = 0.9
#: unit = "s"
#: meaning = "how long it hesitates"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 6.5
#: unit = "m/s"
#: meaning = "how fast it drives"

param OPT_ADV_DISTANCE = Range(24, 42)
param OPT_STOP_TIME = Range(0.3, 0.9)
param OPT_ADV_SPEED = Range(4, 6.5)

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 2, 0) for 0.6 seconds
    do BrakeOnPath(advKerb, 1) until self.pose[3] < 0.05
    do Park() for globalParameters.OPT_STOP_TIME seconds
    do DrivePath(ownLane(egoRoute), globalParameters.OPT_ADV_SPEED)
