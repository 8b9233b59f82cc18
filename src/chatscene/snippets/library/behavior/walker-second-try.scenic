#: description = "The pedestrian steps out, goes back to the edge, waits a moment and then darts across after all."
#: rephrasings = [
#:   "He starts over, thinks better of it, then changes his mind again and runs across right before us.",
#:   "The non-motorist entered the roadway, returned to the edge, and subsequently ran into the path of Vehicle 1.",
#:   "ped out, back, pause, then dash across",
#:   "The target aborts a first crossing attempt and begins a second one at running speed.",
#:   "First she goes, then back, then again she runs over the street.",
#:   "A dithering walker retreats once and on the second attempt bolts over the road.",
#:   "False start by the kid, back to the kerb, and off he goes for real.",
#:   "After one abandoned attempt somebody makes a rush for the other pavement.",
#:   "She stepped out, bottled it and went back, then a moment later made a run for it.",
#:   "Pedestrian stepped from the curb, retreated, waited briefly, and then ran across the roadway.",
#:   "Ped out, back, short wait, then sprints over.",
#:   "The pedestrian target enters the lane, withdraws, waits at the edge and then crosses at running speed.",
#:   "The boy goes on road, goes back, waits, and then runs over anyhow.",
#:   "Walker: one aborted attempt, dwell at edge, second attempt at run speed completes the crossing.",
#:   "His first go came to nothing and he returned to the side; but hardly had she relaxed when he made a break for it.",
#:   "He's gone back, good, but don't trust him yet, see, he's gone for it after all, and at a run.",
#:   "she stepped out, chickened out, waited a sec, then just ran for it",
#:   "After a false start that took him back to the pavement, the pedestrian raced over.",
#:   "His first attempt he abandoned; he bided at the roadside; his second he made at a run.",
#:   "First time she went back, stood at the side, next time she ran and crossed.",
#:   "Has a go, loses his bottle, back to the side, counts to three and sprints it.",
#:   "Aborted pedestrian entry followed by wait at the edge and renewed rapid crossing",
#:   "FALSE START! Attempt number two is a SPRINT",
#:   "The girl ventures, retreats, lingers and then scoots across.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["turn-back", "hesitate", "cross", "accelerate"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.2
#: high = 3.4
#: unit = "m/s"
#: meaning = "how fast it goes at first"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 14.0
#: high = 38.0
#: unit = "m"
#: meaning = "how far the ego still has to go when the adversary reaches its line"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 1.2
#: high = 2.2
#: unit = "m"
#: meaning = "how far from the ego's line it first turns back"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.4
#: high = 1.0
#: unit = "s"
#: meaning = "how long it waits"
#: [[parameters]]
#: name = "OPT_ADV_SPRINT"
#: low = 3.8
#: high = 6.5
#: unit = "m/s"
#: meaning = "how fast it runs across"

param OPT_ADV_SPEED = Range(2.2, 3.4)
param OPT_ADV_DISTANCE = Range(14, 38)
param OPT_ADV_REACH = Range(1.2, 2.2)
param OPT_STOP_TIME = Range(0.4, 1)
param OPT_ADV_SPRINT = Range(3.8, 6.5)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 3.14159) until abs(offsetFrom(egoRoute, self)) > globalParameters.OPT_ADV_REACH + 0.9
    do Halt() until self.pose[3] < 0.1
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do MoveAhead(globalParameters.OPT_ADV_SPRINT, 3.14159)
