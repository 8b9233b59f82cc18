#: description = "The adversary comes toward the ego in the oncoming lane."
#: rephrasings = [
#:   "Ahead, in the lane of opposite traffic, facing the ego.",
#:   "It approaches from the front on the other side of the road.",
#:   "The car is on the opposing lane, some distance away.",
#:   "Coming the other way, left of the ego's lane.",
#:   "The motorcyclist rides toward the ego in the counter lane.",
#:   "Vehicle 2 was traveling in the opposite direction in the adjacent lane.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "egoRoute", "oppositeLane"]
#: provides = ["AdvAgent", "advTrajectory"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: position = "oncoming"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 60.0
#: high = 95.0
#: unit = "m"
#: meaning = "how far ahead of the ego it starts"

param OPT_GEO_Y = Range(60, 95)

advTrajectory = oppositeLane
AdvAgent = new AdvClass at pointOn(advTrajectory, levelOn(advTrajectory, egoRoute, globalParameters.OPT_GEO_Y)),
    facing directionOn(advTrajectory, levelOn(advTrajectory, egoRoute, globalParameters.OPT_GEO_Y)),
    with behavior AdvBehavior()
