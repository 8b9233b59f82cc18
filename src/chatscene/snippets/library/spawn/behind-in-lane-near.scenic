#: description = "The adversary is close behind the ego in the same lane."
#: rephrasings = [
#:   "Right at the rear of the ego.",
#:   "somebody's sitting on our tail",
#:   "following veh, same lane, short gap",
#:   "Vehicle 2 was immediately behind Vehicle 1 in the same lane.",
#:   "The target is located behind the VUT at a small longitudinal distance.",
#:   "It is so near at the back of the ego.",
#: ]
#: adversaries = ["car", "truck", "motorcycle", "bicycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advTrajectory"]
#: origin = "own code"
#: [slots]
#: position = "behind"
#: distance = "near"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 6.8
#: high = 8.5
#: unit = "m"
#: meaning = "how far behind the ego it starts"

param OPT_GEO_Y = Range(6.8, 8.5)

advTrajectory = extended(egoRoute, 10)
AdvAgent = new AdvClass at pointOn(advTrajectory, 10 - globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, 10 - globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
