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
#:   "Woman leaves the pavement and comes up our lane toward us.",
#:   "Hitchhiker steps out, strolls down our lane to face us.",
#:   "Ped enters ego lane, proceeds on foot contrary to traffic.",
#:   "Have a man step off the kerb and walk at us.",
#:   "FACE TO FACE: pedestrian wanders up MY lane at me",
#:   "An old lady with a shopping trolley stepped down into the lane and set about walking along it, straight in the direction of our bonnet.",
#:   "The adult dummy moves out into the VUT's lane, turns to face it and proceeds along that lane in opposition to traffic at walking speed.",
#:   "he wasnt crossing at all officer he got into my lane and then kept coming up it on foot with his eyes on my windscreen",
#:   "A person goes down from the sidewalk and afterwards is walking in my lane against the sense of the cars, so he comes to me.",
#:   "We met him head-on, if one may say so of a gentleman on foot, he having left the verge and begun to stroll up our lane.",
#:   "Put a walker in front of the AV who goes into its lane and marches up it toward the AV as though it were a footpath.",
#:   "It was getting dark and I nearly didn't see her. A woman with a pushchair came off the pavement into the lane I was in and, instead of going over to the other side, walked along it towards me, right into the traffic.",
#:   "The pedestrian stood at the edge of the road until V1 was near. He then entered V1's lane and turned through ninety degrees, so that he was walking against the traffic and toward V1's front. He did not run, and he did not leave the lane again.",
#:   "There's a big difference between somebody who wants to cross and this chap. He's in your lane, yes, but he has turned towards you and he's walking up it, so he isn't going to be gone in a moment; the gap's closing from both ends.",
#:   "Caller on the coast road says a male, dark coat, possibly confused, has stepped into the carriageway. He's on foot in the caller's own lane and heading toward him, against the traffic, at an ordinary walking pace, and takes no notice of the horn.",
#:   "The soldier slung his bag over his shoulder, got down off the bank and took to the lane. He did not cross it. He walked up it, the wrong way, to meet the headlights, with the even step of a man who has far to go.",
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
