#: description = "The pedestrian steps into the lane and walks along it toward the ego, against the traffic."
#: rephrasings = [
#:   "There's a bloke coming down our lane on foot, straight at us.",
#:   "The pedestrian was walking in the roadway against traffic.",
#:   "ped in our lane, walking toward us",
#:   "The adult target walks longitudinally toward the VUT in its lane.",
#:   "The man goes in the middle of our lane in false direction, to us.",
#:   "A stranded motorist tramps back up the lane with a fuel can.",
#:   "Someone steps off the pavement and trudges to meet us head-on.",
#:   "An old woman shuffles up the carriageway the wrong way.",
#:   "Some fella stepped into my lane and just walked up it towards me, cool as you like.",
#:   "Pedestrian entered the travel lane and was walking in it toward Unit 1.",
#:   "Ped in lane, on foot towards us, steady walk.",
#:   "The pedestrian target enters the lane and walks longitudinally in opposition to the test vehicle.",
#:   "The man goes on my lane and walks to me, against the cars.",
#:   "Walker travels along our lane head-on at walking speed, doesn't cross it.",
#:   "She left the verge, turned to face him and came walking up the middle of his lane as if he were not there.",
#:   "Dispatch, I've got a guy on foot in the lane, strolling into oncoming traffic, coming my way.",
#:   "some dude is literally walking in the lane towards me??",
#:   "A man was seen strolling down the traffic lane into the face of approaching cars.",
#:   "He took to the lane itself and walked up it, with his face to the vehicles bearing down on him.",
#:   "One person is walking in middle of my lane coming opposite, as if it is park.",
#:   "Taking the air in the middle of my lane, he is, ambling up to meet me.",
#:   "Longitudinal walking of pedestrian in own lane in direction opposite to traffic",
#:   "MAN STROLLS DOWN MY LANE TOWARDS ME",
#:   "The man marches up the lane to meet us.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: pedestrian walking along road against traffic; own code"
#: [slots]
#: actions = ["slow", "wrong-way"]
#: place = "road"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 0.8
#: high = 1.4
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 32.0
#: high = 50.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 0.8
#: high = 1.8
#: unit = "m"
#: meaning = "how far from the ego's line it turns into the lane"

param OPT_ADV_SPEED = Range(0.8, 1.4)
param OPT_ADV_DISTANCE = Range(32, 50)
param OPT_ADV_REACH = Range(0.8, 1.8)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 3.5
    do MoveAhead(1.4) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    # A quarter turn against the ego's direction, from whichever side it comes.
    do MoveAhead(globalParameters.OPT_ADV_SPEED, -1.57 if offsetFrom(egoRoute, self) > 0 else 1.57)
