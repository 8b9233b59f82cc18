#: description = "The oncoming pedestrian steps into the ego's lane, pauses there in doubt and then goes on across."
#: rephrasings = [
#:   "Someone coming our way cuts over, dithers in our lane, then carries on to the far side.",
#:   "A pedestrian walking against traffic entered the lane, paused, and then completed the crossing.",
#:   "oncoming ped crosses, hesitates mid-lane, continues",
#:   "The approaching target interrupts its crossing within the VUT's lane.",
#:   "The person comes to us, goes in the lane, waits a little and goes further over.",
#:   "A walker who meets us halts before our bumper unsure which way to jump.",
#:   "The old lady heading toward us wavers in the road before she makes it over.",
#:   "Midway to the other pavement, the passer-by facing us stops and thinks.",
#:   "A chap walking towards me strolled out into my lane, stood there umming and ahhing, then went over.",
#:   "Pedestrian, who was walking facing traffic, entered the lane, paused, and then continued to the opposite side.",
#:   "Ped facing us, steps in, unsure, waits, then crosses.",
#:   "The pedestrian target, approaching in the opposite direction, enters the lane, dwells there briefly and then completes the crossing.",
#:   "A woman comes against me on foot, goes in my lane, thinks, then goes to other side.",
#:   "Walker heading towards us steps off the edge, single dwell in lane, continues across.",
#:   "He had been coming up the road to meet her when he stepped in her way, seemed to wonder what he was about, and then passed over.",
#:   "Jogger's coming toward you, he's in your lane, he can't decide, let him, right, he's gone over.",
#:   "guy walking towards me stepped into my lane, stood there like idk, then crossed",
#:   "A man on foot coming the other way entered the lane, lingered uncertainly and then made for the far side.",
#:   "He was walking to meet my client's car; he came into its lane, tarried in doubt, and passed over.",
#:   "Facing me one lady was coming walking, came into road, stood thinking, and afterwards crossed.",
#:   "Walks up towards me, wanders out, stops for a ponder in my lane and then ambles over.",
#:   "Lane entry of facing pedestrian with irresolute dwell and subsequent completion of crossing",
#:   "MAN WALKS AT ME, STOPS TO THINK, THEN CROSSES",
#:   "The walker coming our way enters the lane, dithers and goes over.",
#:   "Walker meeting us turns in, stands there undecided, then completes his crossing.",
#:   "Facing pedestrian crosses our lane with one baffled stop midway.",
#:   "Old man heading our way: into lane, stuck wondering, then over.",
#:   "Toward us, into our lane, a doubtful halt, and finally across.",
#:   "Let a jogger who's approaching us enter our lane, dither, finish crossing.",
#:   "A woman who had been walking down the road in our direction set foot in our lane, came to a halt as if she'd forgotten something, then finished her crossing.",
#:   "The dummy moves opposite to the VUT's direction of travel, enters its lane laterally, is at rest there for two seconds and resumes until the lane is cleared.",
#:   "The schoolboy was on his way towards me when he swung into my lane, stuck there not knowing whether to run or stay, and afterwards got himself to the other side.",
#:   "Please have somebody walk along the road against our travel, step in front of the ego, stand there unsure for a moment and proceed to the far kerb.",
#:   "One uncle come from front, walk into my lane, stop there blur blur, think finish already then go across.",
#:   "Watch the postman coming to meet you: he's off the kerb, he's stopped in your lane, doesn't know if you've seen him, okay, on he goes to the other side.",
#:   "I was driving up the lane and he was walking down it, so we could see one another perfectly well. All the same he stepped out in front of me, came to a stop with his stick in the air, and after some thought he continued over to the far verge.",
#:   "Pedestrian 1 was walking south, facing northbound V1. He veered into the northbound lane, ceased walking for an estimated three seconds, looking alternately at V1 and at the far curb, and thereupon resumed and reached that curb.",
#:   "Her face was towards us the whole time, which is why I remember it. She came on, turned into our lane, and there all her resolve seemed to leave her; she stood, bit her lip, looked at the opposite gate, and only then walked through to it.",
#:   "Bug report: VRU approaching head-on along the shoulder, heading changes to crossing, velocity drops to zero inside ego lane for 2.1 s. Tracker then decides it is static. VRU goes on toward the far side and our car has already begun to roll. Please reproduce.",
#:   "I was out with the dog, going along against the cars as you're meant to. I went in the road to get over to the stile, and there's this car with nobody in it, so I stopped right in its way, not sure of it, and then I went on over.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior", "advFacing"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "hesitate", "cross"]
#: position = "oncoming"
#: place = "road"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.0
#: high = 4.6
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 22.0
#: high = 36.0
#: unit = "m"
#: meaning = "distance to the ego at which it steps in"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.2
#: high = 1.6
#: unit = "m"
#: meaning = "how far from the ego's line it pauses"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.4
#: high = 1.4
#: unit = "s"
#: meaning = "how long it pauses"

param OPT_ADV_SPEED = Range(3, 4.6)
param OPT_ADV_DISTANCE = Range(22, 36)
param OPT_STOP_DISTANCE = Range(0.2, 1.6)
param OPT_STOP_TIME = Range(0.4, 1.4)

# It faces against the ego's direction.
advFacing = 3.14159

behavior AdvBehavior():
    do Halt() until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for 1 seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 1.4) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt() until self.pose[3] < 0.1
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
