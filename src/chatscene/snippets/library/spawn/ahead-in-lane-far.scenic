#: description = "The adversary is far ahead of the ego in the same lane."
#: rephrasings = [
#:   "Some fifty metres in front, in the lane of the ego.",
#:   "there's something way down the road in our lane",
#:   "lead veh, same lane, large gap, > 35 m",
#:   "Vehicle 2 was in the same lane a considerable distance ahead of Vehicle 1.",
#:   "The target is located in the path of the VUT at a large initial distance.",
#:   "It is far before the ego in the same lane.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advTrajectory"]
#: origin = "own code"
#: [slots]
#: position = "ahead"
#: distance = "far"
#: place = "road"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 38.0
#: high = 56.0
#: unit = "m"
#: meaning = "how far ahead of the ego it starts"

param OPT_GEO_Y = Range(38, 56)

advTrajectory = egoRoute
AdvAgent = new AdvClass at pointOn(advTrajectory, globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
