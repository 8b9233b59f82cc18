#: description = "The adversary is far ahead of the ego in the lane to its right."
#: rephrasings = [
#:   "Well down the road, one lane to the right.",
#:   "there's something a long way ahead in the lane on our right",
#:   "adjacent right lane, > 35 m ahead",
#:   "Vehicle 2 was a considerable distance ahead in the adjacent lane to the right.",
#:   "The target is located in the nearside neighbouring lane at a large longitudinal distance.",
#:   "In the right lane it is far before the ego.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "rightLane"]
#: provides = ["AdvAgent", "advLane", "advTrajectory"]
#: origin = "own code"
#: [slots]
#: side = "right"
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

advTrajectory = rightLane
advLane = advTrajectory
AdvAgent = new AdvClass at pointOn(advTrajectory, globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
