#: description = "The adversary comes toward the ego in the oncoming lane from some thirty metres ahead."
#: rephrasings = [
#:   "A few car lengths off, heading for the ego in the opposite lane.",
#:   "here comes one the other way, not far off",
#:   "opposing lane, medium distance",
#:   "Vehicle 2 was traveling toward Vehicle 1 in the opposing lane, having closed to several car lengths.",
#:   "The target approaches in the opposing lane at a medium distance.",
#:   "In the lane of contrary direction, not so far from the ego.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "egoRoute", "oppositeLane"]
#: provides = ["AdvAgent", "advTrajectory"]
#: origin = "own code"
#: [slots]
#: position = "oncoming"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 24.0
#: high = 44.0
#: unit = "m"
#: meaning = "how far ahead of the ego it starts"

param OPT_GEO_Y = Range(24, 44)

advTrajectory = oppositeLane
AdvAgent = new AdvClass at pointOn(advTrajectory, levelOn(advTrajectory, egoRoute, globalParameters.OPT_GEO_Y)),
    facing directionOn(advTrajectory, levelOn(advTrajectory, egoRoute, globalParameters.OPT_GEO_Y)),
    with behavior AdvBehavior()
