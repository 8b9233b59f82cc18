#: description = "The pedestrian steps out, suddenly stops, and then walks on diagonally."
#: rephrasings = [
#:   "A person enters the carriageway, halts, and goes on at a slant.",
#:   "The pedestrian freezes short of the lane and afterwards cuts across it obliquely.",
#:   "Someone pauses on the road, then sets off at an angle along it.",
#:   "The walker comes to a standstill and continues in a diagonal line.",
#:   "After a sudden stop the adversary drifts slantwise over the lane.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["hesitate", "stop", "diagonal"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.0
#: high = 4.0
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 14.0
#: high = 55.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_ADV_ANGLE"
#: low = 0.45
#: high = 1.0
#: unit = "rad"
#: meaning = "how far its slanted way turns from straight across"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 1.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far from the ego's line it stops"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.5
#: high = 1.5
#: unit = "s"
#: meaning = "how long it stands"

param OPT_ADV_SPEED = Range(1, 4)
param OPT_ADV_DISTANCE = Range(14, 55)
param OPT_ADV_ANGLE = Range(0.45, 1)
param OPT_STOP_DISTANCE = Range(1, 3)
param OPT_STOP_TIME = Range(0.5, 1.5)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt() until self.pose[3] < 0.1
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    # Slanted along the ego's direction, from whichever side it comes.
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE if offsetFrom(egoRoute, self) > 0 else -globalParameters.OPT_ADV_ANGLE)
