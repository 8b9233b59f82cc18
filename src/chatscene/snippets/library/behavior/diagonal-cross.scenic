#: description = "The pedestrian crosses the road diagonally, slanting along it."
#: rephrasings = [
#:   "A person walks over the carriageway at a slant rather than straight across.",
#:   "The pedestrian takes an oblique line through the lane ahead of the ego.",
#:   "A jaywalker cuts the road at an angle.",
#:   "Someone wanders across on a long diagonal, with their back to the ego.",
#:   "The cyclist drifts over the street slantwise.",
#: ]
#: adversaries = ["pedestrian", "bicycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "diagonal"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.0
#: high = 4.5
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 14.0
#: high = 50.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_ADV_ANGLE"
#: low = 0.45
#: high = 0.95
#: unit = "rad"
#: meaning = "how far its way turns from straight across"

param OPT_ADV_SPEED = Range(1, 4.5)
param OPT_ADV_DISTANCE = Range(14, 50)
param OPT_ADV_ANGLE = Range(0.45, 0.95)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE if offsetFrom(egoRoute, self) > 0 else -globalParameters.OPT_ADV_ANGLE)
