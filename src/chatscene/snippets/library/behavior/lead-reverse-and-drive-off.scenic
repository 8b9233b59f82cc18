#: description = "The car ahead stops hard, reverses a little and then drives off forward."
#: rephrasings = [
#:   "He overshoots, jams it in reverse, comes back at us and then shoots off.",
#:   "Vehicle 1 braked to a stop, backed up a short distance and departed in its original direction.",
#:   "Lead stops, backs, then forward again.",
#:   "The target brakes to standstill, moves rearward toward the VUT and afterwards accelerates away.",
#:   "The car ahead missed something, it goes back some metres and later forward again.",
#:   "The removal van in front slams to a halt, backs up to read a sign and moves on.",
#:   "A bus driver overran the stop: brake, reverse, then away down the road.",
#:   "Forward, stop, backward, forward: the driver before us cannot make up his mind.",
#:   "The car in front slammed to a stop, rolled back a yard or two, then off he went.",
#:   "The lead vehicle came to an abrupt stop, backed a short distance, and then departed forward.",
#:   "Bus ahead: emergency stop, bit of R, then D and away.",
#:   "The lead vehicle brakes to rest, travels rearward briefly and subsequently departs in the original direction.",
#:   "Truck before me stops strong, goes little back, then goes forward again.",
#:   "Lead: hard stop, short negative v, then positive v and clears; not a permanent reverse.",
#:   "It halted with a jolt, hopped back towards her a little, and then, as if nothing had happened, went on its way.",
#:   "He's overshot his turning, stopped, he's backing up a touch, there, and now he's gone on again.",
#:   "he slammed it, backed up like a metre and then just drove off??? ok",
#:   "The vehicle in front came to a violent halt, edged backwards and then went on its way.",
#:   "You stopped short; you gave ground a yard or so toward my client; you then proceeded as before. Have I that right?",
#:   "Front car jam brake, gostan a bit, then drive off like nothing happened.",
#:   "Stops on a sixpence, comes back at me half a length, then swans off up the road.",
#:   "Abrupt halt of preceding vehicle with short rearward movement and subsequent forward departure",
#:   "STOPS, BACKS UP, LEAVES. Explain this driver",
#:   "The truck in front halts, twitches backward and leaves.",
#: ]
#: adversaries = ["car", "truck", "bus", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["brake", "stop", "reverse", "accelerate"]
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
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_ADV_BACK_SPEED"
#: low = 1.0
#: high = 3.0
#: unit = "m/s"
#: meaning = "how fast it backs up"
#: [[parameters]]
#: name = "OPT_ADV_BACK_TIME"
#: low = 1.0
#: high = 3.0
#: unit = "s"
#: meaning = "for how long it backs up"

param OPT_ADV_DISTANCE = Range(-15, 20)
param OPT_BRAKE = Range(0.5, 1)
param OPT_ADV_BACK_SPEED = Range(1, 3)
param OPT_ADV_BACK_TIME = Range(1, 3)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.05
    do Halt() for 0.5 seconds
    do ReverseStraight(globalParameters.OPT_ADV_BACK_SPEED) for globalParameters.OPT_ADV_BACK_TIME seconds
    do DrivePath(advTrajectory, 8)
