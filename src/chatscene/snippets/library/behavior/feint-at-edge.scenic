#: description = "The motorcyclist pretends to cross the road but brakes abruptly at its edge."
#: rephrasings = [
#:   "The rider lunges toward the carriageway and pulls up hard at the kerb.",
#:   "A motorbike feigns entering the street, then slams on the brakes at the border of the lane.",
#:   "The cyclist makes as if to go over and stops dead at the roadside.",
#:   "The adversary starts out as though it would cross and brakes sharply before the lane.",
#:   "The pedestrian runs at the road and stops short at the edge, confusing the ego.",
#:   "A fake crossing: it darts forward and halts at the very margin of the roadway.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario turning-obstacle; own code"
#: [slots]
#: actions = ["brake", "stop"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.5
#: high = 7.0
#: unit = "m/s"
#: meaning = "how fast it rides at the road"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 2.0
#: high = 16.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 1.4
#: high = 2.3
#: unit = "m"
#: meaning = "how far from the ego's line it comes to rest"

param OPT_ADV_SPEED = Range(3.5, 7)
param OPT_ADV_DISTANCE = Range(2, 16)
param OPT_STOP_DISTANCE = Range(1.4, 2.3)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt()
