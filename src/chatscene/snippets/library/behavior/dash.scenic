#: description = "The pedestrian dashes across the road at a run."
#: rephrasings = [
#:   "A runner sprints over the street in front of the ego and does not slow down.",
#:   "The pedestrian races through the lane from one kerb to the other.",
#:   "A child chasing a ball tears across the carriageway.",
#:   "Someone bolts over the road at top speed right before the vehicle.",
#:   "The person hurries across flat out, without looking.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "accelerate"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.5
#: high = 7.0
#: unit = "m/s"
#: meaning = "how fast it runs"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 2.0
#: high = 16.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to run"

param OPT_ADV_SPEED = Range(3.5, 7)
param OPT_ADV_DISTANCE = Range(2, 16)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
