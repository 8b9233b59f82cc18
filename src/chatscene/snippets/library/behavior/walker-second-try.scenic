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
#:   "Steps off, scurries home to the kerb, ponders, then bolts over.",
#:   "Ped enters, withdraws, short wait at edge, then crosses at a run.",
#:   "Give me a jogger who aborts, lingers at the side, then sprints across.",
#:   "First she came, then back, she waited, then quick quick over.",
#:   "the kid went out went back counted to three n pelted across",
#:   "An old man put himself into the road, backed out of it, stood awhile at the edge, and then made a dash for the other side.",
#:   "The pedestrian target's first entry is cancelled by a return to the kerb; following a dwell time, it traverses the lane at sprint speed.",
#:   "Fine, he's seen you, he's stepped back on the pavement and he's waiting. Don't speed up just yet... what did I say? There he goes, flat out.",
#:   "The woman with the pram has come on the street, returned herself to the border, reflected one moment and after all she has run to the other side.",
#:   "Who'd have thought that someone who had already retreated from the lane and stood there quietly would, moments later, fling himself across it at full speed?",
#:   "On her second attempt she flew over the road in front of us, the first having ended in a retreat and a spell of waiting.",
#:   "I was approaching at a moderate speed when a youth walked out from between the shops. He saw my car and went back to the side, where he remained, so I took my foot off the brake. At that very moment he changed his mind and came tearing over the road.",
#:   "A witness on a bicycle told us that the pedestrian had been \"like somebody testing the water\". She entered the carriageway, drew back to its edge and hung about there for a second or two. Then, with Vehicle 1 now far closer, she shot out and ran the entire way across.",
#:   "Parameter sheet, two-attempt crossing. Attempt one: pedestrian walks into the lane and reverses to the roadside. Dwell there, zero speed, one to three seconds. Attempt two: straight over at a sprint. Our intent estimator drops to \"not crossing\" during the dwell and the ego re-accelerates, which is exactly the wrong thing.",
#:   "Three times I've told this at the depot. Little lad with a football comes off the kerb, sees my bus, hops back on it. Good lad, I think. He stands there, toes over the edge, looking at me, and I'm already rolling again when whoosh, over he goes like a rabbit, ball under his arm.",
#:   "He ventured forth, and the headlights drove him home again; he stayed at the brink of the pavement with his hat in his hand, so that Marie took it for settled that she was to go first. It was then that he ran, coat-tails out, right across before her bonnet to the other shore.",
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
