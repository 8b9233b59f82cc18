#: description = "The adversary is level with the ego in the lane to the left of the ego."
#: rephrasings = [
#:   "The car starts side by side with the ego in the lane to the left of the ego.",
#:   "In the target lane on the left, abreast of the ego.",
#:   "Door to door with the ego, one lane over on the left.",
#:   "The other vehicle is parallel to the ego on the left.",
#:   "Right next to it on the left, in the adjoining lane.",
#:   "Vehicle 2 was alongside Vehicle 1 in the lane on the left.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "leftLane"]
#: provides = ["AdvAgent", "advLane", "advTrajectory"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: position = "beside"
#: side = "left"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = -3.0
#: high = 4.5
#: unit = "m"
#: meaning = "how far ahead of the ego it starts"

param OPT_GEO_Y = Range(-3, 4.5)

advTrajectory = extended(leftLane, 20)
advLane = advTrajectory
AdvAgent = new AdvClass at pointOn(advTrajectory, 20 + globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, 20 + globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
