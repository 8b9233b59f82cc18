#: description = "The oncoming pedestrian walks along the edge of the road and suddenly turns off across the ego's lane."
#: rephrasings = [
#:   "She's coming our way on the side and without a look turns straight over in front of us.",
#:   "A pedestrian walking against traffic turned abruptly and crossed the path of Vehicle 1.",
#:   "oncoming ped, sudden right-angle turn across lane",
#:   "The target approaches beside the lane and then crosses it perpendicularly.",
#:   "The cyclist comes from front on the border and then goes directly over our lane.",
#:   "Somebody who meets us decides all at once to change pavements.",
#:   "A kid on a bike heading toward us hangs a left over the road.",
#:   "The postman coming up the street makes straight for a door on the other side.",
#:   "He was plodding up the verge towards me and then turned on his heel and cut straight over.",
#:   "Pedestrian was walking along the shoulder facing traffic when he abruptly turned and crossed in front of Unit 1.",
#:   "Cyclist along edge, facing us, sudden turn-off thru our lane.",
#:   "The target moves along the road edge opposite to the test vehicle's heading and without warning changes course across the lane.",
#:   "A man walks at the side in my direction, suddenly he turns and goes over before me.",
#:   "Edge walker comes at us, then heading snaps ~90 deg into our lane and keeps going, no pause.",
#:   "She was coming along the edge as good as gold, and then she wheeled about and went over right under his nose.",
#:   "Walker facing you on the shoulder, fine, oh no, he's turned and he's going right over in front of you.",
#:   "she was walking on the side coming towards me n then randomly turned and went across",
#:   "A pedestrian who had been keeping to the roadside toward the car abruptly veered over the lane.",
#:   "He came along the margin facing the defendant and then, with no sign given, struck out across.",
#:   "He is coming along the road side opposite to me, then without seeing he took turn and crossed.",
#:   "Minding his own business along the edge, coming my way, and then wheels off right across my bonnet.",
#:   "Sudden course change of facing roadside walker or cyclist across own lane",
#:   "WALKING ALONG THE SIDE... AND SUDDENLY ACROSS!",
#:   "The jogger facing us along the roadside swings off across the lane.",
#: ]
#: adversaries = ["pedestrian", "bicycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior", "advFacing"]
#: origin = "own code"
#: [slots]
#: blocker = false
#: actions = ["oncoming", "swerve", "cross"]
#: position = "oncoming"
#: place = "road"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.4
#: high = 4.2
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 4.0
#: high = 20.0
#: unit = "m"
#: meaning = "distance to the ego at which it turns across"

param OPT_ADV_SPEED = Range(2.4, 4.2)
param OPT_ADV_DISTANCE = Range(4, 20)

# It faces against the ego's direction.
advFacing = 3.14159

behavior AdvBehavior():
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for 1 seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 1.57)
