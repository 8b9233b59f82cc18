#: description = "The pedestrian runs into the road, then turns back to where it came from."
#: rephrasings = [
#:   "A person enters the lane and suddenly reverses direction to the kerb it left.",
#:   "The pedestrian changes their mind halfway and returns to the side they started from.",
#:   "Someone steps out, spots the ego, and retreats.",
#:   "The walker goes into the carriageway and hurries back again.",
#:   "Having reached the middle, the adversary about-faces and withdraws.",
#:   "She runs out, has second thoughts and nips back to the pavement.",
#:   "The pedestrian entered the roadway and then returned to the side of origin.",
#:   "ped into lane, reverses course, back to kerb",
#:   "A kid ran out, saw me and legged it back to the pavement he'd come from.",
#:   "The juvenile ran into the roadway, reversed direction, and returned to the curb.",
#:   "Ped runs in, about-face, back to same side.",
#:   "The child pedestrian target runs into the lane and then returns to its starting side.",
#:   "The boy runs on the road and then runs back again.",
#:   "Runner enters lane, flips heading 180, exits where it entered; once only, picks nothing up.",
#:   "She was half over before she saw the headlights, and she spun about and fled back to where she had started.",
#:   "Child's run out, he's seen you, he's turned tail, he's gone back to his mum.",
#:   "kid ran into the street then noped right back out",
#:   "A child dashed into the road but thought the better of it and hurried back to safety.",
#:   "She ran in, and then, never having reached the far side, she retraced her steps to the near one.",
#:   "The boy run out then scared already, run back same side.",
#:   "Runs out, clocks my cab, and it's back to Mummy double quick.",
#:   "Pedestrian dash into lane with reversal to side of origin",
#:   "NOPE! Runs out, spins round, runs back",
#:   "The runner rushes in and retreats to where he started.",
#:   "Girl races out, wheels about, races home to her kerb.",
#:   "Pedestrian: runs in, reverses heading, leaves by entry side.",
#:   "Out like a rabbit and back down the same hole.",
#:   "Bloke dashes into traffic, regrets it, dashes back",
#:   "Why run out at all if you're only going to run back?",
#:   "I need a child who sprints into the lane and, without ever getting over, spins on its heel and heads for the pavement it left.",
#:   "She was back beside the very lamp post she'd started from, having charged into the road and then thought again all in two seconds.",
#:   "The pedestrian ran from the west curb into the roadway, did not reach the east curb, and turned and ran again toward the west.",
#:   "The little boy comes running in the road, he turns himself around, and he is running to the same footpath where he was before.",
#:   "A jogger went into the road in front of our car at full pace, did a one-eighty on the spot and went off the same way.",
#:   "Mum shouted \"come here!\", and so the lad who had just pelted into our lane pelted right out of it again, to her side.",
#:   "His football had gone over the road and he went after it at a run. Some way into the carriageway he must have remembered what they tell them at school, because well short of it he whipped round, empty-handed, and ran as fast as he could to where his friends were.",
#:   "The runner enters the lane of the vehicle under test at constant running speed. As soon as the predetermined point in the lane is reached, the direction of movement is inverted and the runner goes back, at that same speed, to the side of departure.",
#:   "You could hear the tram bell, that's what did it. The student had bolted off the platform into our lane, heard the bell, and turned as if on a spring, so by the time we stopped he was up on the platform again as though nothing had been.",
#:   "Thing about the elderly is they don't trust their first idea. This dear old soul scuttled out in front of my truck faster than I'd have thought possible, took fright at the size of me, and straightaway scuttled back to the shop doorway she'd come out of.",
#:   "It's the return that fools the planner. A pedestrian who's running in from the left is expected to exit on the right, so the AV steers behind her; instead she flips direction within the lane and leaves on the left, which is precisely where we were steering.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "turn-back"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.5
#: high = 5.0
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 10.0
#: high = 36.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 0.0
#: high = 1.0
#: unit = "m"
#: meaning = "how far from the ego's line it turns back"

param OPT_ADV_SPEED = Range(1.5, 5)
param OPT_ADV_DISTANCE = Range(10, 36)
param OPT_ADV_REACH = Range(0, 1)

behavior AdvBehavior():
    # Earlier where it has farther to go, and briskly where the ego would be gone otherwise.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(5) until abs(offsetFrom(egoRoute, self)) < max(2.5, globalParameters.OPT_ADV_SPEED * headway(egoRoute, ego, self) / 8)
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_ADV_REACH)
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 3.14159)
