#: description = "The adversary is just ahead of the ego in the lane to its left, hardly a car's length away."
#: rephrasings = [
#:   "Half a length in front, one lane to the left.",
#:   "its rear wheels are about level with our bonnet, on our left",
#:   "adjacent left lane, slightly ahead",
#:   "Vehicle 2 was slightly ahead of Vehicle 1 in the adjacent lane to the left.",
#:   "The target is located in the offside neighbouring lane with a small longitudinal lead.",
#:   "In the left lane it is a little bit before the ego.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "leftLane"]
#: provides = ["AdvAgent", "advLane", "advTrajectory"]
#: origin = "own code"
#: [slots]
#: side = "left"
#: position = "ahead-beside"
#: distance = "near"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 4.6
#: high = 8.0
#: unit = "m"
#: meaning = "how far ahead of the ego it starts"

param OPT_GEO_Y = Range(4.6, 8)

advTrajectory = leftLane
advLane = advTrajectory
AdvAgent = new AdvClass at pointOn(advTrajectory, globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
