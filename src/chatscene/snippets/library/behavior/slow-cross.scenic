#: description = "The pedestrian crosses very slowly."
#: rephrasings = [
#:   "An elderly person shuffles over the carriageway.",
#:   "The pedestrian creeps through the lane and takes a long time about it.",
#:   "Someone plods across at a crawl, staying in the way of the ego.",
#:   "The walker dawdles over the street.",
#:   "A person with a walking frame inches across the road.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["ego"]
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
#: low = 15.0
#: high = 40.0
#: unit = "m"
#: meaning = "distance to the ego at which it starts to move"

param OPT_ADV_SPEED = Range(0.6, 1.4)
param OPT_ADV_DISTANCE = Range(15, 40)

behavior AdvBehavior():
    do Halt() until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
