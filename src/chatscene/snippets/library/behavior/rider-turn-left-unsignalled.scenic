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
