#: description = "The car turns left from the lane beside and crosses right in front of the ego."
#: rephrasings = [
#:   "From the lane on our right he hooks left straight across our bonnet.",
#:   "Vehicle 2 attempted a left turn from the right-hand lane and crossed the path of vehicle 1.",
#:   "Left turn from wrong lane, cuts across us.",
#:   "The target turns left out of the adjacent lane through the path of the VUT.",
#:   "It turns to left but it was on right of us, so it passes before our nose.",
#:   "The taxi next to us spots an address opposite and swings over us.",
#:   "A truck in the outer lane lumbers left across everybody.",
#:   "A scooter on the kerbside lane veers over in front of us to the far side.",
#:   "The car next to me decided he wanted the left turn and just swung clean across my bonnet.",
#:   "Unit 2 executed an improper left turn from the right-hand lane, crossing the path of Unit 1 proceeding straight.",
#:   "Pickup in adj lane hooks L through ego's path; wrong lane for turn.",
#:   "Target positioned in the neighbouring lane initiates a left turn that traverses the path of the VUT.",
#:   "A car at my side turns to left and goes directly before me, he should not turn from that lane.",
#:   "Side-lane vehicle does an illegal left from the wrong lane, T-boning geometry straight in front of us.",
#:   "They were rolling along side by side when he hauled his bike round to the left, straight over her road and off down the turning.",
#:   "That fellow on your right wants to go left from the wrong lane, and he's turning right across us to do it.",
#:   "car in the other lane just decided to go left THROUGH me basically",
#:   "The taxi swung left out of the wrong lane and passed directly under the nose of the car travelling with it.",
#:   "So from the neighbouring lane, without first joining hers, you turned to the left in front of my client?",
#:   "He is in the side lane only, and suddenly takes left turn from there, full blocking my way.",
#:   "Muppet on my flank wants to go left, so he goes left. Never mind that I'm in between.",
#:   "Left turn from neighbouring lane conflicting with ego's straight path.",
#:   "WRONG LANE LEFT TURN RIGHT ACROSS MY HOOD",
#:   "The motorbike alongside scythed left past our front.",
#: ]
#: adversaries = ["car", "motorcycle", "truck", "emergency-vehicle"]
#: requires = ["advLane", "egoRoute", "rightLane"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "turn-left"]
#: side = "right"
#: leader = false
#: place = "road"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 25.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 7.0
#: high = 14.0
#: unit = "m"
#: meaning = "how far ahead of the ego it stays"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 5.0
#: unit = "m/s"
#: meaning = "how fast it turns"

param OPT_ADV_DISTANCE = Range(0, 25)
param OPT_ADV_AHEAD = Range(7, 14)
param OPT_ADV_SPEED = Range(4, 5)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and headway(rightLane, ego, self) > 5
    do TurnOff(1.2, globalParameters.OPT_ADV_SPEED, 7)
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for 4 seconds
    do Halt()
