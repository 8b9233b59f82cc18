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
#:   "Bus leaves its stop in two bites: a twitch, a wait, then out.",
#:   "Parked scooter: rolls a foot, stops, ponders, joins our lane.",
#:   "Out she came in the end, after one false start from the kerb.",
#:   "First the parked car bottles it, then it sets off into our lane.",
#:   "Let the parked moped dither once before it really joins the road.",
#:   "The estate at the kerb rolled forward a touch and checked itself, and when our car was nearly there the driver decided to come out into the lane regardless.",
#:   "Target vehicle aborts its departure from the parking lane after 0.6 s, is stationary for a set time, and then carries out the departure in front of the VUT.",
#:   "Claimant says the parked Peugeot moved, then stood, so he assumed he'd been seen, whereupon it moved off again and drove into his lane.",
#:   "Could you do a parked car that begins leaving, has doubts, stands for a couple of seconds and in the end pulls into the ego's lane and drives along it?",
#:   "Le bus, he commence to leave the stop, he brakes, he reflects two seconds, and finally he goes into my lane before me.",
#:   "If they nudge out and stop like that, don't think they're waiting for you, cause look, now she's coming out of the space for real.",
#:   "The wheels of the parked Golf had turned and it crept off by a hand's breadth, so I lifted off. It stopped dead. I thought good, she's letting me go, and I'd just put my foot back on when the thing moved out into the lane in front of me after all.",
#:   "V2 was legally parked along the east curb. Its driver initiated a pull-out, applied the brakes, and remained motionless for about two seconds while looking in the mirror; V2 then left the curb completely and proceeded in the lane of V1.",
#:   "Episode twelve, the ditherer. A motorcyclist sits at the roadside with his engine going, paddles forward with his boots, loses heart and stops. Any planner that takes that for a yield gets punished, because two seconds later he lets the clutch out and rides off in your lane.",
#:   "I drive the 38 and I know how it looks from behind. I'd let the brake off at the stop, then saw a car in my mirror and put it on again, sat there, wasn't sure, and then I thought I'd been let out and took the bus into the lane.",
#:   "Mum said the man couldn't decide. His car was parked and it went a tiny bit and then it stood still, and we waited to see, and then it really did go, out of its place and onto the road where we were driving.",
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
