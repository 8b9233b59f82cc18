#: description = "The adversary is far behind the ego in the lane to its left."
#: rephrasings = [
#:   "Coming from a long way back, one lane to the left.",
#:   "something's coming up from way behind in the lane on our left",
#:   "adjacent left lane, > 35 m behind",
#:   "Vehicle 2 was approaching from the rear in the adjacent lane to the left.",
#:   "The target is located in the offside neighbouring lane far behind the VUT.",
#:   "In the left lane it is far after the ego.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "leftLane"]
#: provides = ["AdvAgent", "advLane", "advTrajectory"]
#: origin = "own code"
#: [slots]
#: side = "left"
#: position = "behind-beside"
#: distance = "far"
#: place = "road"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 35.0
#: high = 39.0
#: unit = "m"
#: meaning = "how far behind the ego it starts"

param OPT_GEO_Y = Range(35, 39)

advTrajectory = extended(leftLane, 40)
advLane = advTrajectory
AdvAgent = new AdvClass at pointOn(advTrajectory, 40 - globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, 40 - globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
