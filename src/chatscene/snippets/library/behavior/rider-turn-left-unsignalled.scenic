#: description = "The rider ahead suddenly brakes and turns off to the left across the road without a hand signal."
#: rephrasings = [
#:   "The cyclist in front hangs a left with no warning whatsoever.",
#:   "The bicyclist made a sudden left turn across the path of Vehicle 1 without signaling.",
#:   "bike ahead turns left, no signal",
#:   "The target ahead turns left across the VUT's path without any prior indication.",
#:   "The cyclist before us goes at once left without showing the hand.",
#:   "A courier up ahead flicks left for a doorway without so much as a shoulder check.",
#:   "The scooter we follow peels off to the left unannounced.",
#:   "Not looking behind, the biker heads left for a driveway right when we want to pass.",
#:   "The cyclist in front grabbed his brakes and hooked off left over the road, no arm out, nothing.",
#:   "The lead bicyclist slowed abruptly and turned left across the roadway, failing to signal.",
#:   "Bike ahead brakes sharp, hooks L, no signal.",
#:   "The leading two-wheeler target brakes and turns left across the carriageway without indicating.",
#:   "The bicycle before me brakes suddenly and goes left over the street, he does not show the hand.",
#:   "Rider ahead turns left with no indication: short brake, then leaves our lane to the left.",
#:   "She never put her arm out; she just checked, and cut away left across the road ahead of him.",
#:   "Mind that moped in front, no signal and he's jammed on and peeled off to the left!",
#:   "biker in front braked and went left outta nowhere, no hand signal or anything",
#:   "The moped rider checked his speed and swept left over the road without indicating, the inquest heard.",
#:   "You gave no sign by arm or lamp, you braked, and you crossed to the left before her?",
#:   "Front bike suddenly brake and turn left, never put hand also.",
#:   "Does he stick an arm out? Does he heck. Brakes on, over to the left he goes.",
#:   "Unannounced left turn with sudden braking by leading two-wheeler.",
#:   "BIKER BRAKES AND TURNS LEFT - NO SIGNAL",
#:   "The cyclist ahead checked, then veered off left unheralded.",
#:   "Cyclist ahead pulls up sharp and bears left, no arm given.",
#:   "Leading scooter: hard brake, left across road, indicator never used.",
#:   "Biker in front slows abruptly, then sneaks off left without a sign.",
#:   "NO SIGNAL, NO LOOK: bike ahead brakes, swings left",
#:   "Guy ahead brakes, then leftward over our road, hands never leaving the bars.",
#:   "The lad in front of me on a mountain bike squeezed his brakes and shot off to the left over the road, no arm out.",
#:   "Let the moped in front of the AV brake out of the blue and veer away to the left over the carriageway, without any indication beforehand.",
#:   "Had she put her left hand out before slowing and wheeling over to that side in front of you? No, sir, she had given nothing at all.",
#:   "The leading bicyclist target keeps to the right, decelerates abruptly and departs to the left across the lane, the test deliberately omitting any hand signal.",
#:   "The cycle man before our car has stopped pedalling and pressed brake, then he cut to left side of the road, hand he did not show.",
#:   "Our motorcyclist, riding ahead, checked hard and took himself off to the left side of the road; that he meant to do so he told nobody.",
#:   "I was about to go by an old gentleman on his bicycle, who was keeping well in to the right. Without looking or lifting an arm he braked and came round to the left, right over my lane, and disappeared into an allotment path on the other side.",
#:   "V2, a moped travelling ahead of V1 near the right edge of the lane, was braked suddenly. Its rider then steered left and crossed the roadway at nearly a right angle. Neither direction indicator nor hand signal was in use, as the footage of V1 confirms.",
#:   "You can't trust that they'll tell you. This girl ahead on the bike, watch her shoulders, she's stopped pedalling, she's braking, and off over the road she goes, leftward. She ought to have stuck her arm out for that, but she didn't, so you must read it.",
#:   "Riders, please, I'm one of you, but signal! Chap in front of me today hit his brakes for no visible reason and then peeled away left in front of my wheel and of the car behind me, clean over the road, with both hands on the grips.",
#:   "It is the missing warning that makes this case hard. The motorcycle leads, hugging the right of the lane so that you feel invited past it; it brakes, quite suddenly; and in the next instant it lies over to the left and leaves across the road with dark indicators.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["brake", "swerve", "turn-left"]
#: position = "ahead"
#: leader = false
#: place = "road"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.6
#: high = 2.4
#: unit = "m/s"
#: meaning = "how fast it turns"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -20.0
#: high = 5.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts at the latest"
#: [[parameters]]
#: name = "OPT_REACT_DISTANCE"
#: low = 4.0
#: high = 18.0
#: unit = "m"
#: meaning = "how far behind it the ego is when it acts"
#: [[parameters]]
#: name = "OPT_TURN_RADIUS"
#: low = 2.5
#: high = 4.0
#: unit = "m"
#: meaning = "the radius of its turn"

param OPT_ADV_SPEED = Range(1.6, 2.4)
param OPT_ADV_DISTANCE = Range(-20, 5)
param OPT_REACT_DISTANCE = Range(4, 18)
param OPT_TURN_RADIUS = Range(2.5, 4)

behavior AdvBehavior():
    # It keeps right, as if to let the ego pass.
    do DrivePath(advTrajectory, 5, -1.9) until self.pose[3] > 4.2 and (headway(egoRoute, ego, self) < globalParameters.OPT_REACT_DISTANCE or distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE)
    do BrakeOnPath(advTrajectory, 0.5, -1.9) until self.pose[3] < globalParameters.OPT_ADV_SPEED
    do TurnOff(1.5, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_TURN_RADIUS)
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
