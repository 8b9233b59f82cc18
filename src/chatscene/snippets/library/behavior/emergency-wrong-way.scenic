#: description = "The emergency vehicle comes toward the ego at speed on the wrong side, in the ego's lane, and moves over only at the last moment."
#: rephrasings = [
#:   "An ambulance comes tearing at us on our side of the road.",
#:   "The fire apparatus was travelling against traffic in the lane of vehicle 1.",
#:   "EMS oncoming in our lane, high speed.",
#:   "The emergency vehicle approaches the VUT head-on on its path.",
#:   "The police drives against us on our lane with blue light.",
#:   "A fire engine passes a jam on the wrong side and fills our windscreen.",
#:   "Blue lights straight ahead, nose to nose, until they jink away.",
#:   "The paramedics take our side of the street and bear down on us.",
#:   "There was a police car hurtling straight at me on my side, and he left it till the last second to get out of the way.",
#:   "Responding ambulance was traveling the wrong direction in Unit 1's lane at high speed and returned to its side just before impact.",
#:   "Fire truck head-on in our lane, fast, ducks out last sec.",
#:   "A priority vehicle approaches in the opposing direction within the lane of the test vehicle and vacates it only at minimal time-to-collision.",
#:   "The ambulance drives fast against me on my side and goes away only at the end.",
#:   "Oncoming EV occupies ego lane, high v, returns to own lane at very low TTC.",
#:   "It came at them with its lights blazing, on their half of the road, and peeled away when they had already shut their eyes.",
#:   "There's a fire engine coming the wrong way at you at a lick, get over, he won't shift until the very end.",
#:   "omg ambulance coming AT me in my own lane n it only swerved like at the very end",
#:   "A police car speeding on the wrong half of the road missed an oncoming motorist by a whisker after yielding at the eleventh hour.",
#:   "The fire engine was on my client's side, bearing down on him, and gave up that side only when a collision seemed inevitable.",
#:   "Wah, ambulance drive opposite in my lane so fast, last moment then siam.",
#:   "Blue lights head-on in my lane, going like stink, and he waits till I've said my prayers before he shifts over.",
#:   "Head-on approach of responding emergency vehicle in own lane with belated evasion",
#:   "COP CAR PLAYS CHICKEN WITH ME in my lane",
#:   "The fire truck barrels at us against the flow and flinches aside at the death.",
#: ]
#: adversaries = ["emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "wrong-way", "fast"]
#: position = "oncoming"
#: place = "road"
#: maneuver = "straight"
#: leader = false
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 55.0
#: high = 80.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 11.5
#: high = 14.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_SWERVE_DISTANCE"
#: low = 5.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far from the ego it moves back"

param OPT_ADV_DISTANCE = Range(55, 80)
param OPT_ADV_SPEED = Range(11.5, 14)
param OPT_SWERVE_DISTANCE = Range(5, 30)

behavior AdvBehavior():
    do DrivePath(advTrajectory, 8) until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(against(ownLane(egoRoute)), 1, 0, globalParameters.OPT_ADV_SPEED) until headway(egoRoute, ego, self) < globalParameters.OPT_SWERVE_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
