#: description = "The pedestrian runs into the lane and charges along it straight at the ego."
#: rephrasings = [
#:   "A madman runs into our lane and comes sprinting at the bonnet.",
#:   "The pedestrian ran in the lane of travel toward the front of Vehicle 1.",
#:   "ped charges us head-on in our lane",
#:   "The target enters the lane and runs toward the VUT.",
#:   "The person runs to our car from front in our own lane.",
#:   "A furious protester storms up the carriageway to confront us.",
#:   "Someone pelts down the tarmac to flag us down, arms waving.",
#:   "The jogger swings into the road and hurtles to meet us.",
#:   "A madman ran out into the road and came sprinting straight at my bonnet.",
#:   "Subject ran into the lane and rushed head-on at Unit 1.",
#:   "Ped runs in, sprints along lane at us, head-on.",
#:   "The pedestrian target enters the lane and runs longitudinally towards the front of the test vehicle.",
#:   "A man runs on my lane directly to my car, very fast.",
#:   "Walker actor at running speed, aims at ego front along the lane, doesn't sidestep.",
#:   "He put his head down like a bull and came pelting up the road at them.",
#:   "There's a fella sprinting right at you, down your own lane, stop the vehicle.",
#:   "this crazy guy ran into the road and straight up CHARGED my car",
#:   "A man rushed into the lane and hurled himself toward the front of an oncoming car.",
#:   "He did not run across, my lord; he ran in and then ran full tilt at the car itself.",
#:   "Siao one, run into the road then run straight to my car like want to fight.",
#:   "Comes pelting down the lane at me like a bull at a gate.",
#:   "Running frontal approach of pedestrian along own lane",
#:   "PEDESTRIAN BULL-RUSHES MY CAR",
#:   "The woman storms down the lane at our grille.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["wrong-way", "fast"]
#: place = "road"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.5
#: high = 6.0
#: unit = "m/s"
#: meaning = "how fast it runs"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 32.0
#: high = 50.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 1.5
#: high = 2.6
#: unit = "m"
#: meaning = "how far from the ego's line it turns into the lane"

param OPT_ADV_SPEED = Range(3.5, 6)
param OPT_ADV_DISTANCE = Range(32, 50)
param OPT_ADV_REACH = Range(1.5, 2.6)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 5
    do MoveAhead(2.5) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    # A quarter turn against the ego's direction, from whichever side it comes.
    do MoveAhead(globalParameters.OPT_ADV_SPEED, -1.57 if offsetFrom(egoRoute, self) > 0 else 1.57)
