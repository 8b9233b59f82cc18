#: description = "The adversary is in the ego's blind spot, close behind in the lane to its right."
#: rephrasings = [
#:   "Just behind the right shoulder of the ego, one lane over.",
#:   "it's hiding in our blind spot on the right",
#:   "blind spot, right lane, bumper overlapping",
#:   "Vehicle 2 was in the blind zone of Vehicle 1 in the adjacent right lane.",
#:   "The target is located in the nearside blind spot of the VUT.",
#:   "In the dead angle of the mirror, right lane.",
#: ]
#: adversaries = ["car", "truck", "motorcycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "rightLane"]
#: provides = ["AdvAgent", "advLane", "advTrajectory"]
#: origin = "own code"
#: [slots]
#: side = "right"
#: position = "behind-beside"
#: distance = "near"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 3.0
#: high = 6.0
#: unit = "m"
#: meaning = "how far behind the ego it starts"

param OPT_GEO_Y = Range(3, 6)

advTrajectory = extended(rightLane, 20)
advLane = advTrajectory
AdvAgent = new AdvClass at pointOn(advTrajectory, 20 - globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, 20 - globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
