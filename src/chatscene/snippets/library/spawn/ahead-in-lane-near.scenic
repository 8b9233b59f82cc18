#: description = "The adversary is close ahead of the ego in the same lane."
#: rephrasings = [
#:   "Just in front of the ego, nearly bumper to bumper.",
#:   "it's right on our nose, only a couple of metres ahead",
#:   "lead veh, same lane, short gap",
#:   "Vehicle 2 was directly ahead of Vehicle 1 in the same lane with little headway.",
#:   "The target is located in front of the VUT at a small longitudinal distance.",
#:   "It drives so near before the ego, in the same lane.",
#: ]
#: adversaries = ["car", "truck", "motorcycle", "bicycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advTrajectory"]
#: origin = "own code"
#: [slots]
#: position = "ahead"
#: distance = "near"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 7.5
#: high = 12.0
#: unit = "m"
#: meaning = "how far ahead of the ego it starts"

param OPT_GEO_Y = Range(7.5, 12)

advTrajectory = egoRoute
AdvAgent = new AdvClass at pointOn(advTrajectory, globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
