#: description = "The cyclist swings into the ego's lane from the side and rides on slowly ahead of it."
#: rephrasings = [
#:   "A rider enters from the kerb and takes the lane at low speed.",
#:   "The cyclist turns onto the carriageway right before the ego and dawdles along.",
#:   "A bike pulls out of the side and stays in front of the vehicle.",
#:   "The motorcyclist cuts in from the roadside and crawls onward.",
#:   "The rider merges from beside the road and forces the ego to tuck in behind.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cut-in", "slow"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.5
#: high = 3.8
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 6.0
#: high = 40.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts"

param OPT_ADV_SPEED = Range(1.5, 3.8)
param OPT_ADV_DISTANCE = Range(6, 40)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 2.5
    do DrivePath(egoRoute, globalParameters.OPT_ADV_SPEED)
