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
#:   "Biker blasts by, nips in front, and it's stoppies on our bonnet.",
#:   "Let a coupé pass the robotaxi, slice in and anchor up at once.",
#:   "He got past me, parked his rear bumper in my lap and braked.",
#:   "Pass, chop in, brake: coupé has just done all three to you.",
#:   "Il me double, he throws himself in my front and brakes like an idiot.",
#:   "First the taxi drew level and went by; next thing it was in our lane with a metre to spare, and its tail lights were glaring at us.",
#:   "A passing vehicle re-occupied the lane directly ahead of the VUT at 4 m headway and thereupon decelerated at 6 m/s², completing the triple manoeuvre.",
#:   "The motorcyclist wasn't content with having left us behind, so he veered over before our bumper and squeezed his brakes as hard as he dared.",
#:   "My rear-ending him was his own doing, given that he'd only that instant come by in the outer lane, wedged himself ahead of me and jumped on his pedal.",
#:   "See how he's going past you on the outside? He'll want back in. There, much too soon, no room, and now he's braking on top of it.",
#:   "Was it in temper that you went by her, forced your car into the few feet before hers, and there pulled your speed right down?",
#:   "Two miles of flashing his lights from the lane alongside, and then he finally gets ahead of my truck. Does he drive off? Not a bit of it: he swings his hatchback in right under my grille and stands on the brakes, so that I've got forty tonnes trying to climb over his roof.",
#:   "V2 was to the left rear of V1 in the adjacent lane and travelling faster. After completing the pass it moved into V1's lane with roughly one car length of clearance, whereupon its operator made an abrupt brake application which V1's driver avoided by steering onto the shoulder.",
#:   "I don't know what I'd done to upset the young man on the motorcycle. He came by me at the side with a rude gesture, pulled across so that his back wheel was almost touching my number plate, and then he slowed down with a jolt, on purpose, I am quite certain of that.",
#:   "Aggressor template, please: it starts in the lane next to ours, a little behind, and goes faster than we do until it has put us behind it. It then moves over into our lane with hardly any gap and immediately brakes hard, so the AV has to deal with both at once.",
#:   "Story time on the pod. I'm in a driverless cab, texting, when this red sports car goes sailing past the window. Fine. Except it then shoves itself in front, I mean tight, and bang, hits the brakes, probably for clicks, and my phone goes flying into the dashboard.",
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
