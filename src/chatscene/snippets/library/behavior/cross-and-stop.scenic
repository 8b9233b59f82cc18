#: description = "The pedestrian suddenly crosses the road and stops in front of the ego."
#: rephrasings = [
#:   "Someone walks out onto the carriageway and comes to a standstill right before the oncoming ego.",
#:   "The pedestrian steps into the lane and halts in the ego's path.",
#:   "A person on foot begins to cross and then freezes in the middle of the lane.",
#:   "The cyclist rides across and stands still in the way of the ego.",
#:   "The adversary moves over the street from the side and stays there, blocking the lane.",
#:   "The motorcyclist crosses abruptly and comes to a halt in the centre of the intersection.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "stop"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.2
#: high = 5.0
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 6.0
#: high = 40.0
#: unit = "m"
#: meaning = "how far the ego still has to go when the adversary starts to move"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.0
#: high = 1.0
#: unit = "m"
#: meaning = "how far from the ego's line it comes to rest"

param OPT_ADV_SPEED = Range(1.2, 5)
param OPT_ADV_DISTANCE = Range(6, 40)
param OPT_STOP_DISTANCE = Range(0, 1)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt()
