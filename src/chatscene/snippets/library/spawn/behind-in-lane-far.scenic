#: description = "The adversary is far behind the ego in the same lane."
#: rephrasings = [
#:   "A long way back in the lane of the ego.",
#:   "you can see it in the mirror, still a fair bit behind us",
#:   "following veh, same lane, large gap, > 35 m",
#:   "Vehicle 2 was approaching from the rear at a considerable distance.",
#:   "The target is located behind the VUT at a large initial distance.",
#:   "It is far after the ego in the same lane.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advTrajectory"]
#: origin = "own code"
#: [slots]
#: position = "behind"
#: distance = "far"
#: place = "road"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 35.2
#: high = 39.0
#: unit = "m"
#: meaning = "how far behind the ego it starts"

param OPT_GEO_Y = Range(35.2, 39)

advTrajectory = extended(egoRoute, 40)
AdvAgent = new AdvClass at pointOn(advTrajectory, 40 - globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, 40 - globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
