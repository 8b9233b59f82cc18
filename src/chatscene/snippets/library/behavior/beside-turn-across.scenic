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
#:   "He was next to me and took a left over my nose!",
#:   "Simulate a lorry hanging a left from the neighbouring lane, through the ego's path.",
#:   "Cab alongside, no business turning left from there, went across our bows anyway.",
#:   "Bloke in the outer lane turned left right in front of us",
#:   "Adjacent-lane left-turner sweeps over the trajectory of the subject vehicle.",
#:   "Both vehicles were travelling in parallel until the van to our right made a left-hand turn, sweeping over our lane just in front of the bumper.",
#:   "Let the pickup travel on the ego's right and then have it peel off to the left so that it shaves past the ego's front end.",
#:   "A fire engine took its left turn out of the lane beside the robotaxi, putting its whole length across the way the robotaxi was going.",
#:   "Why would anybody drive on my right-hand side and then steer to the left-hand road, passing crosswise before my bonnet?",
#:   "The motorcycle had left our right flank and was already disappearing into the side road on the left, having sliced over our lane with a metre or two to spare.",
#:   "Driver of the lorry was in lane next to mine, then he take the left street and his trailer pass across my front.",
#:   "The accident happened because the other party noticed his exit too late. He was running level with us in the next lane over, and instead of carrying on he hauled it to the left, right over our lane, to reach the side street.",
#:   "Scenario description: the target vehicle travels in the same direction as the VUT, in the lane to its right. At the trigger point it executes a left turn, whereby it passes transversely in front of the VUT and leaves the roadway on the far side.",
#:   "You know when your sat nav shouts too late? I reckon that's what did it. The woman in the Fiesta to my right suddenly went for the left-hand road, never mind that I was sitting in the lane she had to cross.",
#:   "Keep an eye on vehicles level with you, especially ones slowing a bit as if hunting for an address. This van on our right has just chucked a left through your lane, and had you been daydreaming you would have gone into his door.",
#:   "I drive an artic for a living, and what I saw from the cab was plain stupid. A motorbike on the car's right flank banked over to the left and shot across its front wheels into the side road.",
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
