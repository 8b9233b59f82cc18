#: description = "The adversary is just ahead of the ego in the lane to its right, hardly a car's length away."
#: rephrasings = [
#:   "Half a length in front, one lane to the right.",
#:   "its rear wheels are about level with our bonnet, on our right",
#:   "adjacent right lane, slightly ahead",
#:   "Vehicle 2 was slightly ahead of Vehicle 1 in the adjacent lane to the right.",
#:   "The target is located in the nearside neighbouring lane with a small longitudinal lead.",
#:   "In the right lane it is a little bit before the ego.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "rightLane"]
#: provides = ["AdvAgent", "advLane", "advTrajectory"]
#: origin = "own code"
#: [slots]
#: side = "right"
#: position = "ahead-beside"
#: distance = "near"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 4.6
#: high = 8.0
#: unit = "m"
#: meaning = "how far ahead of the ego it starts"

param OPT_GEO_Y = Range(4.6, 8)

advTrajectory = rightLane
advLane = advTrajectory
AdvAgent = new AdvClass at pointOn(advTrajectory, globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
