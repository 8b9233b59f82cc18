#: description = "The pedestrian crosses very slowly."
#: rephrasings = [
#:   "An elderly person shuffles over the carriageway.",
#:   "The pedestrian creeps through the lane and takes a long time about it.",
#:   "Someone plods across at a crawl, staying in the way of the ego.",
#:   "The walker dawdles over the street.",
#:   "A person with a walking frame inches across the road.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "slow"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 0.6
#: high = 1.4
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"

param OPT_ADV_SPEED = Range(0.6, 1.4)
param OPT_ADV_DISTANCE = Range(12, 48)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
