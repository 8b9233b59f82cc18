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
