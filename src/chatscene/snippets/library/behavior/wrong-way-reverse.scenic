#: description = "The oncoming car comes the wrong way in the ego's lane, stops, and backs away."
#: rephrasings = [
#:   "he realises he's on the wrong side, stops and backs off",
#:   "Vehicle 2, travelling the wrong way, stopped and reversed away from Vehicle 1.",
#:   "wrong-way, halts, reverses out of it",
#:   "The target approaches in the lane of the VUT against its direction, stops and moves rearwards.",
#:   "The truck goes in contrary direction, then stands and goes back with reverse gear.",
#:   "A van driving up our lane pulls up and retreats.",
#:   "The bus on the wrong side notices us and rolls backwards again.",
#:   "Seeing the ego, the ghost driver slams it into reverse.",
#:   "twit was coming at me on my side, realised, pulled up and then went backwards out of it",
#:   "V2, traveling the wrong way in V1's lane, stopped and then reversed away from V1.",
#:   "Bus wrong way in our lane: halts, R gear, moves off backwards.",
#:   "The oncoming target in the VUT's lane halts and subsequently travels rearwards, increasing the distance to the VUT.",
#:   "The car comes false way in my lane, stops, and then he goes backward away from me.",
#:   "Ghost driver that retreats: head-on, v=0, then negative v so the gap opens up again.",
#:   "The lorry had met them face to face in their own lane; it stopped, considered, and withdrew the way it had come, tail first.",
#:   "He's come up the wrong side, he's noticed you, he's stopping, and here come the reversing lights: he's giving you the road back.",
#:   "car came the wrong way in our lane, stopped all embarrassed and reversed away",
#:   "A van found itself in the face of traffic, pulled up and withdrew the way it came, backwards",
#:   "Upon finding my client before you in her own lane, you stopped and took your vehicle rearwards away from her?",
#:   "He came opposite in our lane, realise wrong, stop, then gostan all the way",
#:   "Wrong way up my lane, sees the error of his ways, stops, finds reverse and slinks off",
#:   "Wrong-way opposing traffic in own lane with standstill and rearward withdrawal",
#:   "Wrong-way truck realizes mistake and REVERSES OUT",
#:   "The bus facing us in our lane stopped and backpedalled.",
#: ]
#: adversaries = ["car", "truck", "bus"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "wrong-way", "stop", "reverse"]
#: position = "oncoming"
#: maneuver = "straight"
#: leader = false
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 32.0
#: unit = "m"
#: meaning = "distance to the ego at which it brakes"
#: [[parameters]]
#: name = "OPT_ADV_BACK"
#: low = 1.5
#: high = 4.0
#: unit = "m/s"
#: meaning = "how fast it backs up"
#: [[parameters]]
#: name = "OPT_ADV_BACK_TIME"
#: low = 2.0
#: high = 5.0
#: unit = "s"
#: meaning = "for how long it backs up"

param OPT_ADV_SPEED = Range(5, 9)
param OPT_ADV_DISTANCE = Range(12, 32)
param OPT_ADV_BACK = Range(1.5, 4)
param OPT_ADV_BACK_TIME = Range(2, 5)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < 75
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 0.8 and gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(against(egoRoute)) until self.pose[3] < 0.05
    do Halt() for 0.4 seconds
    do ReverseStraight(globalParameters.OPT_ADV_BACK) for globalParameters.OPT_ADV_BACK_TIME seconds
    do Halt()
