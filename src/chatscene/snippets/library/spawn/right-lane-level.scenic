#: description = "The adversary is level with the ego in the lane to the right of the ego."
#: rephrasings = [
#:   "The car starts side by side with the ego in the lane to the right of the ego.",
#:   "In the target lane on the right, abreast of the ego.",
#:   "Door to door with the ego, one lane over on the right.",
#:   "The other vehicle is parallel to the ego on the right.",
#:   "Right next to it on the right, in the adjoining lane.",
#:   "Vehicle 2 was alongside Vehicle 1 in the lane on the right.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "rightLane"]
#: provides = ["AdvAgent", "advLane", "advTrajectory"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: position = "beside"
#: side = "right"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = -3.0
#: high = 4.5
#: unit = "m"
#: meaning = "how far ahead of the ego it starts"

param OPT_GEO_Y = Range(-3, 4.5)

advTrajectory = extended(rightLane, 20)
advLane = advTrajectory
AdvAgent = new AdvClass at pointOn(advTrajectory, 20 + globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, 20 + globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
