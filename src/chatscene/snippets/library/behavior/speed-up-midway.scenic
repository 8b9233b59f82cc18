#: description = "The pedestrian starts across slowly and suddenly breaks into a run."
#: rephrasings = [
#:   "A person strolls into the road and then accelerates sharply in front of the ego.",
#:   "The walker begins at an easy pace and sprints the rest of the way.",
#:   "Midway over the carriageway the pedestrian speeds up without warning.",
#:   "Someone ambles off the kerb, then bolts.",
#:   "The cyclist rolls into the lane and suddenly pedals hard.",
#: ]
#: adversaries = ["pedestrian", "bicycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "accelerate"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 0.8
#: high = 2.0
#: unit = "m/s"
#: meaning = "how fast it starts"
#: [[parameters]]
#: name = "OPT_ADV_SPRINT"
#: low = 4.5
#: high = 7.0
#: unit = "m/s"
#: meaning = "how fast it runs in the end"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 18.0
#: high = 55.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 1.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far from the ego's line it breaks into a run"

param OPT_ADV_SPEED = Range(0.8, 2)
param OPT_ADV_SPRINT = Range(4.5, 7)
param OPT_ADV_DISTANCE = Range(18, 55)
param OPT_ADV_REACH = Range(1, 3)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    do MoveAhead(globalParameters.OPT_ADV_SPRINT)
