#: description = "The adversary is far ahead of the ego in the lane to its left."
#: rephrasings = [
#:   "Well down the road, one lane to the left.",
#:   "there's something a long way ahead in the lane on our left",
#:   "adjacent left lane, > 35 m ahead",
#:   "Vehicle 2 was a considerable distance ahead in the adjacent lane to the left.",
#:   "The target is located in the offside neighbouring lane at a large longitudinal distance.",
#:   "In the left lane it is far before the ego.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "leftLane"]
#: provides = ["AdvAgent", "advLane", "advTrajectory"]
#: origin = "own code"
#: [slots]
#: side = "left"
#: position = "ahead-beside"
#: distance = "far"
#: place = "road"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 36.0
#: high = 50.0
#: unit = "m"
#: meaning = "how far ahead of the ego it starts"

param OPT_GEO_Y = Range(36, 50)

advTrajectory = leftLane
advLane = advTrajectory
AdvAgent = new AdvClass at pointOn(advTrajectory, globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
