#: description = "The oncoming pedestrian breaks into a sprint and dashes straight across the ego's lane."
#: rephrasings = [
#:   "A walker coming our way takes off like a shot and streaks over in front of us.",
#:   "A pedestrian walking against traffic suddenly ran across the roadway ahead of Vehicle 1.",
#:   "oncoming ped, sudden sprint across lane",
#:   "The target approaches at walking pace and then crosses at running speed.",
#:   "The boy comes slowly to us, then very fast he runs over the lane.",
#:   "Having spied a friend over the road, somebody who meets us tears across.",
#:   "The stroller ahead, facing us, hurtles over to the opposite pavement.",
#:   "A tourist we are about to pass rushes to the other side for a bus.",
#:   "A jogger coming towards me suddenly put on a spurt and legged it right over my lane.",
#:   "The pedestrian, walking toward Unit 1, suddenly sprinted laterally across its lane.",
#:   "Ped facing ego, walks up, then bolts straight over lane.",
#:   "The pedestrian target approaches the VUT head-on and then runs perpendicularly across its lane.",
#:   "A man walks in my direction against me, suddenly he runs fast over my lane.",
#:   "Oncoming ped on foot goes from walk to sprint and cuts our lane at a right angle.",
#:   "He'd been coming along to meet her at a stroll; all at once he took to his heels and shot across her front.",
#:   "Fellow walking up towards you, careful, he's broken into a run, he's going straight over in front!",
#:   "guy was walking towards us all chill then just BOOKED it across our lane",
#:   "A walker heading toward the car abruptly took to his heels across its lane.",
#:   "He was facing my client as he came, and then he ran, without warning, to the far side?",
#:   "One lady walking opposite to me suddenly started running and crossed in front.",
#:   "Comes strolling up to meet me, then someone fires the starting pistol and he's over my lane.",
#:   "Sudden sprint across ego lane by pedestrian approaching head-on.",
#:   "PEDESTRIAN WALKS TOWARD CAR THEN SUDDENLY SPRINTS ACROSS",
#:   "The approaching walker exploded into a run over our lane.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior", "advFacing"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "cross", "fast"]
#: position = "oncoming"
#: place = "road"
#: blocker = false
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 0.9
#: high = 1.8
#: unit = "m/s"
#: meaning = "how fast it walks at first"
#: [[parameters]]
#: name = "OPT_ADV_SPRINT"
#: low = 4.0
#: high = 6.5
#: unit = "m/s"
#: meaning = "how fast it sprints"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 5.0
#: high = 17.0
#: unit = "m"
#: meaning = "distance to the ego at which it sprints across"

param OPT_ADV_SPEED = Range(0.9, 1.8)
param OPT_ADV_SPRINT = Range(4, 6.5)
param OPT_ADV_DISTANCE = Range(5, 17)

# It faces against the ego's direction.
advFacing = 3.14159

behavior AdvBehavior():
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for 1 seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE + 1.5 * abs(offsetFrom(egoRoute, self))
    do MoveAhead(globalParameters.OPT_ADV_SPRINT, 1.57)
