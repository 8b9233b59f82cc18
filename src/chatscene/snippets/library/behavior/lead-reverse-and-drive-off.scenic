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
#:   "Lead brakes to nil, rolls backward a metre, then departs forward.",
#:   "Taxi before us: dead halt, short backing, then onward.",
#:   "The car in front anchors, returns a bit toward us, then proceeds.",
#:   "Alors he stops very strong, makes small reverse, then continues straight.",
#:   "Ambulance ahead pulls up sharply, backs slightly, then heads off again.",
#:   "The van we were following braked to nothing at a gateway, came backwards the length of a bonnet, and then took itself off down the road.",
#:   "Could you make the vehicle ahead of us stop with violence, go astern for a metre or two, and after that drive away normally?",
#:   "He'd slammed his bus to a standstill in front of me, I saw the white lights, he came back a little, and then on he went.",
#:   "V2, leading, was brought to a stop by heavy braking, travelled rearward about two metres toward V1, and left the scene in its initial direction.",
#:   "Poor old lorry couldn't make his mind up: anchors on, stationary, back a tad towards my bumper, into first and away he goes.",
#:   "Reports of a fire engine that stopped with a jerk ahead of a robotaxi, nudged itself backward, and moved ahead again once it had found its address.",
#:   "The satnav must have told them something. First the estate in front stopped so hard its boot came up; then there was the reversing lamp and it crept back at us, not far, perhaps a yard; and then the lamp was out and it was driving on as before.",
#:   "The lead vehicle, initially keeping its distance to the ego, is braked at a high rate to zero. After half a second of standstill it is driven backwards for a short time. Finally it selects forward gear and leaves at ordinary road speed, so that the ego can follow.",
#:   "Now tell the court what happened, in order. Well, he was in front, the pickup. He stood on his brakes and stopped. Then he backed up, towards me, only a little way, I had my hand on the horn. And then he just drove on, forwards, and was gone.",
#:   "I've had a bus do this to me on my own route. Bloke ahead missed his stop, so it's brakes on full, everybody's shopping on the floor, a quick shuffle backwards to the shelter, and then, would you believe it, nobody gets on and off he drives.",
#:   "Ticket: the planner treats the white lights as a permanent reverse and freezes. Repro with a lead truck that comes to an abrupt standstill, travels backwards at the ego for one or two seconds and then moves off ahead and clears the lane.",
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
