#: description = "The pedestrian hurries as far as the edge of the ego's lane, waits there, and hurries over the rest in a second stage."
#: rephrasings = [
#:   "She does it in two goes: a trot out into the road, a stop, and another trot past our bumper.",
#:   "The pedestrian crossed in two stages, stopping beside the travel lane before running across it.",
#:   "ped crosses two-phase: run, wait, run",
#:   "The target performs a staged crossing with an intermediate stop alongside the VUT's lane.",
#:   "He runs until our lane, waits, then runs the second part.",
#:   "A nipper scampers out, checks, and scampers on.",
#:   "Somebody with shopping bags jogs part of the way, lets a moment go by and jogs the remainder.",
#:   "One spurt brings the walker to the lane line, another takes them over.",
#:   "She trotted as far as the edge of my lane, waited on the line, then nipped over the rest.",
#:   "Pedestrian ran to the lane line adjacent to Unit 1's lane, waited, and then hurried across the remainder.",
#:   "Ped quick to lane line, waits there, quick over 2nd half.",
#:   "The pedestrian target crosses rapidly to the boundary of the test vehicle's lane, dwells there, then completes the crossing rapidly.",
#:   "Woman runs to the line next to my lane, stands, and after runs the rest.",
#:   "Crosser in two legs: run, dwell just outside our lane, run through it.",
#:   "He did the far half at a jog, stood on the line while she came up, and then did her half at a jog too.",
#:   "He's got himself as far as the middle, he's waiting on the line, mind, he's going for the other half now.",
#:   "she ran to the edge of my lane, waited there, then ran the rest of the way",
#:   "The pedestrian crossed in a pair of dashes with a wait between them at the lane marking.",
#:   "She hastened to the limit of my client's lane, and no farther; there she waited; then she hastened over the remainder.",
#:   "First half she came fast and stood at my lane line, then second half also fast.",
#:   "Scuttles up to the edge of my lane, hangs about there, then scuttles over the other bit.",
#:   "Split crossing of pedestrian in two rapid legs with wait at own lane boundary",
#:   "CROSSES IN TWO INSTALMENTS: dash, wait, dash",
#:   "The woman scurries to our lane's edge, waits and scurries over the rest.",
#:   "Dashes up to our lane, holds at its border, dashes past us.",
#:   "Two hops: kerb to lane marking, pause, lane marking to kerb.",
#:   "Have the jogger rush to our lane line, wait, rush on.",
#:   "Mum with pram trots out, stands beside our lane, trots through it.",
#:   "Stage 1 quick to lane boundary, dwell, stage 2 quick over the remainder.",
#:   "The waiter scurried over the far lanes with his tray, held back at the line that borders ours, and then scurried through ours to the other kerb.",
#:   "The pedestrian target covers the first part at 2.5 m/s, is halted clear of the VUT's lane at its boundary, and after the dwell time covers the second part at 2.5 m/s.",
#:   "I noticed her because she came quickly as far as the white line next to me, stood on it as on a tightrope, and then went quickly over my bit as well.",
#:   "Set up a man with a suitcase who hastens to the side of the ego's lane but not into it, waits there a while and then hastens over what's left of the road.",
#:   "La señora goes rapid until the line of my lane, there she waits very correct, and after this she goes rapid the second part to the other sidewalk.",
#:   "He has run up to your lane and he's stopped short of it, good boy, but he'll want the other half, and now he's running that too.",
#:   "My dispatcher always tells me to watch for people standing on the paint. This one had trotted out from the left, far lane first, and was stood on the line right beside where I'd be driving. He let a second or so go, and then he trotted in front of me and over.",
#:   "Pedestrian 1 crossed in two movements. In the first she jogged from the east curb to the lane line on the left of V1's lane and remained there, outside the lane. In the second she jogged from that line through V1's lane to the west curb.",
#:   "When you're eight you do as Gran does. Gran took my hand and we ran, and just before the part where the car was coming we stopped on the line and she said wait, and I waited, and then she said now and we ran the other part.",
#:   "The crossing is divided like a play with an interval. Act one, the man hurries out, and breaks off at the very margin of the lane the AV is using; interval, he stands there with his toes at the marking; act two, he hurries over that lane and is off.",
#:   "Nasty for a planner, this, since the person who comes up fast and halts neatly at the brink of the ego's lane looks exactly like someone who is going to give way. After the wait, though, she takes off again at the same fast clip and finishes the crossing.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "hesitate", "accelerate"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.8
#: high = 4.8
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 20.0
#: high = 46.0
#: unit = "m"
#: meaning = "how far the ego still has to go when the adversary reaches its line"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 1.5
#: high = 2.0
#: unit = "m"
#: meaning = "how far from the ego's line it waits"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.4
#: high = 1.6
#: unit = "s"
#: meaning = "how long it waits"

param OPT_ADV_SPEED = Range(2.8, 4.8)
param OPT_ADV_DISTANCE = Range(20, 46)
param OPT_STOP_DISTANCE = Range(1.5, 2)
param OPT_STOP_TIME = Range(0.4, 1.6)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 4
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt() until self.pose[3] < 0.1
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
