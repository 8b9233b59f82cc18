#: description = "The cyclist crosses and brakes suddenly in the middle of the intersection, obstructing the ego."
#: rephrasings = [
#:   "A rider comes out, pulls the brakes hard, and stays in the ego's path.",
#:   "The cyclist stops abruptly halfway over and gets off the bike.",
#:   "The motorcyclist cuts across and slams to a halt in the lane.",
#:   "A bike shoots into the junction and brakes to a standstill in its centre.",
#:   "The rider skids to a stop right before the ego and blocks the way.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario turning-obstacle; own code"
#: [slots]
#: actions = ["cross", "brake", "stop"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.0
#: high = 6.0
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 4.0
#: high = 28.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.0
#: high = 1.0
#: unit = "m"
#: meaning = "how far from the ego's line it comes to rest"

param OPT_ADV_SPEED = Range(3, 6)
param OPT_ADV_DISTANCE = Range(4, 28)
param OPT_STOP_DISTANCE = Range(0, 1)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt()
