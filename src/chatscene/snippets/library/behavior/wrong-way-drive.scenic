#: description = "The oncoming car drives against the traffic in the ego's lane."
#: rephrasings = [
#:   "there's a guy coming straight at us in our own lane",
#:   "Vehicle 2 was travelling the wrong way in the lane of Vehicle 1.",
#:   "wrong-way driver, our lane, head-on",
#:   "The target approaches the VUT in the VUT's lane in the opposite direction at constant speed.",
#:   "A car is driving in the wrong direction on our side of the road.",
#:   "A cyclist rides the wrong way up our lane, towards us.",
#:   "The ghost driver keeps to the ego's side for far too long.",
#:   "A motorbike comes head on, on the side where it has no business.",
#:   "Some doddery old fella was coming straight at me on my side of the road, going the wrong way.",
#:   "A wrong-way driver was traveling toward Unit 1 in its lane, against the flow of traffic.",
#:   "Ghost driver, ego's lane, head-on, holds spd.",
#:   "The target travels in the VUT's lane in the opposite direction at constant speed.",
#:   "A car comes against me in my lane, he drives on false side.",
#:   "Contraflow actor in our lane, no evasive move, head-on all the way.",
#:   "He came on down her side of the road as though it were his own, and never gave an inch.",
#:   "Control, we've got a wrong-way driver in your lane, coming head-on towards you.",
#:   "theres a car coming STRAIGHT for us the wrong way up our lane help",
#:   "A confused pensioner drove into the face of the traffic in its own lane, police said.",
#:   "You were in her lane, going the contrary way, and you maintained your course toward her throughout?",
#:   "One car coming opposite direction in my own lane, wrong side totally, not stopping also.",
#:   "I'm on my side and so's he, and we're pointing at each other. Somebody's wrong and it ain't me.",
#:   "Sustained contraflow travel of opposing vehicle in ego lane.",
#:   "WRONG WAY DRIVER HEAD ON IN MY LANE",
#:   "The truck breasted the traffic in our lane.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: opposite direction; own code"
#: [slots]
#: actions = ["oncoming", "wrong-way"]
#: position = "oncoming"
#: maneuver = "straight"
#: leader = false
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 35.0
#: high = 90.0
#: unit = "m"
#: meaning = "distance to the ego at which it comes over into the ego's lane"
#: [[parameters]]
#: name = "OPT_ADV_OFFSET"
#: low = 0.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far toward its own side it keeps when it meets the ego"

param OPT_ADV_SPEED = Range(4, 9)
param OPT_ADV_DISTANCE = Range(35, 90)
param OPT_ADV_OFFSET = Range(0, 3)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 1 and gap(self, ego) < 36
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED, -globalParameters.OPT_ADV_OFFSET)
