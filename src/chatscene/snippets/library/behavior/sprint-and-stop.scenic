#: description = "The pedestrian suddenly sprints out onto the road in front of the ego and stops."
#: rephrasings = [
#:   "Somebody dashes into the lane and freezes directly in the path of the ego.",
#:   "The pedestrian bolts into the roadway, then stands still before the ego.",
#:   "A child runs out in front of the vehicle and halts there.",
#:   "The person rushes onto the street at full speed and comes to a dead stop.",
#:   "The runner darts out abruptly and blocks the lane by standing in it.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "accelerate", "stop"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 7.0
#: unit = "m/s"
#: meaning = "how fast it runs"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 2.0
#: high = 16.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to run"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.0
#: high = 1.0
#: unit = "m"
#: meaning = "how far from the ego's line it comes to rest"

param OPT_ADV_SPEED = Range(4, 7)
param OPT_ADV_DISTANCE = Range(2, 16)
param OPT_STOP_DISTANCE = Range(0, 1)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt()
