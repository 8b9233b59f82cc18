#: description = "The car overtakes the ego, cuts in and brakes right in front of it."
#: rephrasings = [
#:   "He flies past, dives in and hits the brakes, just to teach us.",
#:   "Vehicle 2 passed, re-entered the lane of vehicle 1 and decelerated sharply.",
#:   "Pass, cut-in, brake-check.",
#:   "The target overtakes the VUT, cuts in and applies strong braking.",
#:   "He overtakes us, comes before us and makes an angry brake.",
#:   "A lorry gets by at last, swings back and stands on everything.",
#:   "The motorcyclist zooms round us and checks us hard once in front.",
#:   "A furious driver storms by, blocks us in and slams down the pedal.",
#:   "he came past, swung in ahead of me and slammed his brakes on right under my nose, brake-checking git",
#:   "Suspect passed the victim, moved in front and brake-checked him.",
#:   "MC: passes, tucks in, hard brk right ahead.",
#:   "Following the pass and re-entry into the VUT's lane, the target performs strong braking at short distance.",
#:   "The car goes by me, comes before me and then brakes very hard, I almost hit him.",
#:   "Road-rage sequence: pass, tuck in, emergency decel - all three within a few seconds.",
#:   "He had swept past, slammed the door on her, and then lit up his brake lights a yard from her bumper.",
#:   "Complainant says the biker went round her, got in front and jammed on the anchors straight away, on purpose.",
#:   "guy overtook us, went in front and brake checked us, so petty",
#:   "A feud on the road saw a motorist pass, move in and punish the follower with his brakes",
#:   "You overtook, you took the lane before my client, and you then braked for no reason but spite?",
#:   "He overtakes, comes in front and immediately puts brake, teaching us lesson or what",
#:   "Round me, in front, brake lights. Classic road rage, that. Insurance'll have a field day",
#:   "Overtaking with close lane return and immediate hard deceleration",
#:   "BRAKE CHECKED by biker who just overtook me",
#:   "The saloon leapfrogged us and clobbered its brakes.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["overtake", "cut-in", "brake"]
#: leader = false
#: maneuver = "straight"
#: position = "behind-beside"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 11.5
#: high = 15.0
#: unit = "m/s"
#: meaning = "how fast it overtakes at most"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 1.0
#: high = 6.0
#: unit = "m"
#: meaning = "how far ahead of the ego it is when it moves over"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.6
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_SPEED = Range(11.5, 15)
param OPT_ADV_AHEAD = Range(1, 6)
param OPT_BRAKE = Range(0.6, 1)

behavior AdvBehavior():
    do DrivePath(advLane, globalParameters.OPT_ADV_SPEED) until headway(egoRoute, ego, self) > globalParameters.OPT_ADV_AHEAD
    do DrivePath(egoRoute, 8) until abs(offsetFrom(egoRoute, self)) < 1
    do BrakeOnPath(egoRoute, globalParameters.OPT_BRAKE) until self.pose[3] < 2
    do DrivePath(egoRoute, 7)
