#: description = "The oncoming car comes the wrong way in the ego's lane, brakes hard, and stops."
#: rephrasings = [
#:   "he's coming at us in our lane and then stamps on it at the last moment",
#:   "Vehicle 2, travelling the wrong way, braked heavily and came to rest in the lane of Vehicle 1.",
#:   "wrong-way, emergency braking, standstill in our lane",
#:   "The target approaches in the lane of the VUT against its direction and brakes fully to standstill.",
#:   "The truck goes in wrong direction, it sees us and brakes strong until it stands.",
#:   "A biker charging up our lane slams everything on and stops dead.",
#:   "The ghost driver realises it and screeches to a halt before the ego.",
#:   "On the wrong side, a van skids to a stop right in our way.",
#:   "he was coming head-on in my lane, and then he stamped on the brakes and pulled up in front of me",
#:   "V2, traveling the wrong way in V1's lane, braked heavily and came to a complete stop.",
#:   "MC wrong way in our lane, emerg. brk, stands.",
#:   "The oncoming target travels in the VUT's lane against the direction of traffic and makes a full braking to standstill.",
#:   "The truck comes on my lane from the front, false way, and then he brakes full and stands.",
#:   "Ghost driver with panic stop: head-on in the ego lane, max decel to v=0, remains nose to nose with the SUT.",
#:   "It had been rushing at them on their own side of the road, when its wheels locked and it stood there, bonnet to bonnet.",
#:   "He's on your side, he's coming straight at you, and he's seen you, slams everything on... stopped.",
#:   "he came at us the wrong way in our lane then slammed the brakes n stopped",
#:   "A ghost driver pulled up with screeching tyres nose to nose with a family car",
#:   "Travelling against the flow, you met my client in her lane and only then braked, violently, to a halt?",
#:   "Wrong side he is coming in our lane, sees us, full brake, standing face to face",
#:   "Some wrong-way wally in my lane, headlights on me, tyres howling, stops dead and we're staring at each other",
#:   "Wrong-way opposing traffic in own lane with hard braking to standstill",
#:   "WRONG WAY biker slams brakes nose to nose with me",
#:   "The lorry charged up our lane from the wrong end and screeched still.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "wrong-way", "brake", "stop"]
#: position = "oncoming"
#: maneuver = "straight"
#: leader = false
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 7.0
#: high = 12.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 15.0
#: high = 45.0
#: unit = "m"
#: meaning = "distance to the ego at which it brakes"

param OPT_ADV_SPEED = Range(7, 12)
param OPT_BRAKE = Range(0.5, 1)
param OPT_ADV_DISTANCE = Range(15, 45)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < 75
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED) until self.pose[3] > 5 and abs(offsetFrom(egoRoute, self)) < 1 and gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(against(egoRoute), globalParameters.OPT_BRAKE)
