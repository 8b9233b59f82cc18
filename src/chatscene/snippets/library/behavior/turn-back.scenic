#: description = "The pedestrian runs into the road, then turns back to where it came from."
#: rephrasings = [
#:   "A person enters the lane and suddenly reverses direction to the kerb it left.",
#:   "The pedestrian changes their mind halfway and returns to the side they started from.",
#:   "Someone steps out, spots the ego, and retreats.",
#:   "The walker goes into the carriageway and hurries back again.",
#:   "Having reached the middle, the adversary about-faces and withdraws.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "turn-back"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.5
#: high = 5.0
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 5.0
#: high = 35.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 0.0
#: high = 1.0
#: unit = "m"
#: meaning = "how far from the ego's line it turns back"

param OPT_ADV_SPEED = Range(1.5, 5)
param OPT_ADV_DISTANCE = Range(5, 35)
param OPT_ADV_REACH = Range(0, 1)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_ADV_REACH)
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 3.14159)
