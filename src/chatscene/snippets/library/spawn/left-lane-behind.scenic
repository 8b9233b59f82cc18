#: description = "The adversary is behind the ego in the lane to the left of the ego."
#: rephrasings = [
#:   "The car starts further back in the lane to the left of the ego.",
#:   "In the target lane on the left, some metres to the rear.",
#:   "It follows the ego, one lane over on the left.",
#:   "The other vehicle comes from the rear left, in a parallel lane.",
#:   "In the blind spot on the left, a few car lengths back.",
#:   "Vehicle 2 was to the rear of Vehicle 1, traveling in the lane on the left.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "leftLane"]
#: provides = ["AdvAgent", "advLane", "advTrajectory"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: position = "behind-beside"
#: side = "left"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 6.0
#: high = 18.0
#: unit = "m"
#: meaning = "how far behind the ego it starts"

param OPT_GEO_Y = Range(6, 18)

advTrajectory = extended(leftLane, 20)
advLane = advTrajectory
AdvAgent = new AdvClass at pointOn(advTrajectory, 20 - globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, 20 - globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
