#: description = "The pedestrian starts to cross, hesitates in the lane, and goes on."
#: rephrasings = [
#:   "A person steps out, pauses on the carriageway in doubt, and then finishes crossing.",
#:   "The pedestrian stops midway for a moment and afterwards continues over the road.",
#:   "Halfway over, the walker falters, waits briefly, and carries on.",
#:   "The cyclist sets off across, pauses, and resumes.",
#:   "The adversary enters the lane, stands undecided, then moves again.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "hesitate"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.0
#: high = 4.0
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 18.0
#: high = 55.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.2
#: high = 2.0
#: unit = "m"
#: meaning = "how far from the ego's line it pauses"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.5
#: high = 2.0
#: unit = "s"
#: meaning = "how long it pauses"

param OPT_ADV_SPEED = Range(1, 4)
param OPT_ADV_DISTANCE = Range(18, 55)
param OPT_STOP_DISTANCE = Range(0.2, 2)
param OPT_STOP_TIME = Range(0.5, 2)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt() until self.pose[3] < 0.1
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
