#: description = "The car ahead stops and abruptly reverses."
#: rephrasings = [
#:   "A vehicle in front halts and rolls backwards toward the ego.",
#:   "The adversary shifts into reverse gear and backs up.",
#:   "The car stops short, then drives backward without looking.",
#:   "The driver ahead suddenly moves in reverse and blocks the lane.",
#:   "The van comes to a stand and backs into the traffic behind it.",
#:   "The fool in front stops and backs right at us.",
#:   "Vehicle 2 came to a stop and then backed toward vehicle 1.",
#:   "It stands and suddenly it goes with the reverse gear.",
#:   "The pickup in front pulled up and then, I kid you not, came flying backwards at me.",
#:   "The vehicle ahead of Unit 1 halted in the lane and suddenly backed up.",
#:   "Truck ahead halts, R gear, quick, towards us.",
#:   "The lead vehicle comes to a standstill and unexpectedly travels rearward in the same lane.",
#:   "Bus before me stands, then suddenly it drives back.",
#:   "Lead: v -> 0, then sharply negative, and it does not drive off forward afterwards.",
#:   "It had stopped, and she waited for it to go on, but it shot back at her instead.",
#:   "He's stopped up there and his reverse lights are on, back off, back off, he's coming at you.",
#:   "car in front stopped then started reversing into me like hello??",
#:   "A lorry halted ahead of the motorist and without notice shot backwards.",
#:   "The vehicle before my client came to rest and then, to his astonishment, moved upon him in reverse.",
#:   "Front car stopped and directly he put reverse, coming towards my bonnet.",
#:   "Pulls up in front, I pull up behind, next thing his boot's in my lap.",
#:   "Unexpected rearward motion of preceding vehicle after standstill",
#:   "FRONT CAR REVERSES AT ME FOR NO REASON",
#:   "The truck in front stops and recoils toward us.",
#:   "White lights, flying backward at me! He'd only just halted up ahead.",
#:   "Make the lorry in front pull up, then jerk into reverse.",
#:   "Lead bus: full halt, then sudden rearward travel at VUT.",
#:   "The saloon before us quit moving, next it charged us backwards.",
#:   "Rammed by the car I was following, which had stopped and reversed.",
#:   "A dustcart we had been following came to a halt in its lane, and without so much as a beep it began driving back at our radiator.",
#:   "The claimant had stopped behind the pickup, which had itself stopped, when its driver engaged reverse without warning and travelled rapidly back towards her.",
#:   "After reaching zero speed the leading vehicle shall, within half a second, travel backwards along the same lane at 3 m/s and not return to forward motion.",
#:   "I want the van up ahead to come to rest and then, all of a sudden, to back down the lane in the direction of the robotaxi.",
#:   "missed his exit i suppose so he pulled up dead in the carrigeway and came tearing backward with us sat right behind him",
#:   "Auto in front has halted, I also halted, and in one second fellow is in back gear and coming to kiss my bumper.",
#:   "The coach had gone past the hotel entrance, that's what I think. It stopped in front of us, I stopped as well and had barely got the handbrake on, and then the great thing was lurching backwards and its rear window was getting bigger and bigger.",
#:   "V1 and V2 were traveling in line. V2 slowed to a stop in the travel lane. Its back-up lamps illuminated almost immediately and V2 accelerated to the rear, toward the front of V1, whose operator sounded the horn.",
#:   "Lesson of the day, and I say this to every pupil: leave room behind the one in front even when he's standing. See this Corsa? It stopped, you stopped, and bang, it's in reverse and heading for us quick. Horn, now, good long one.",
#:   "The brake lights of the car ahead went on and it stood. I remember thinking how quiet the street was. Then came that whine which only a reverse gear makes, and its boot rushed up to my windscreen before I had time to be surprised.",
#:   "Lorry driver here, nothing to hide. I'd overshot the yard, so I stopped in my lane, whacked it into reverse and went back smartly. I never saw the little self-driving car that was behind me until I heard it hooting.",
#: ]
#: adversaries = ["car", "truck", "bus"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario right-turn; own code"
#: [slots]
#: actions = ["stop", "reverse"]
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
#: meaning = "how hard it brakes first"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.0
#: high = 3.5
#: unit = "m/s"
#: meaning = "how fast it backs up"
#: [[parameters]]
#: name = "OPT_ADV_BACK_TIME"
#: low = 1.0
#: high = 4.0
#: unit = "s"
#: meaning = "for how long"

param OPT_ADV_DISTANCE = Range(-15, 20)
param OPT_BRAKE = Range(0.5, 1)
param OPT_ADV_SPEED = Range(1, 3.5)
param OPT_ADV_BACK_TIME = Range(1, 4)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.05
    do Halt() for 0.5 seconds
    do ReverseStraight(globalParameters.OPT_ADV_SPEED) for globalParameters.OPT_ADV_BACK_TIME seconds
    do Halt()
