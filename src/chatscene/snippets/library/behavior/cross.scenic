#: description = "The pedestrian crosses the road without stopping."
#: rephrasings = [
#:   "A person walks straight across the carriageway from one side to the other.",
#:   "The pedestrian goes over the street right in front of the ego.",
#:   "A jaywalker passes through the lane at an even pace and carries on.",
#:   "The cyclist rides across the lane of the ego and leaves it on the far side.",
#:   "The adversary traverses the roadway at right angles, never pausing.",
#:   "The motorcyclist shoots over the road ahead of the ego.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.2
#: high = 5.0
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 10.0
#: high = 54.0
#: unit = "m"
#: meaning = "how far the ego still has to go when the adversary starts to move"

param OPT_ADV_SPEED = Range(1.2, 5)
param OPT_ADV_DISTANCE = Range(10, 54)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
