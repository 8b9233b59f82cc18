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
