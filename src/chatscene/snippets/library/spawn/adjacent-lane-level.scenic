#: description = "The adversary is level with the ego in the neighbouring lane."
#: rephrasings = [
#:   "The car starts side by side with the ego in the neighbouring lane.",
#:   "In the target lane beside, abreast of the ego.",
#:   "Door to door with the ego, one lane over beside.",
#:   "The other vehicle is parallel to the ego beside.",
#:   "Right next to it beside, in the adjoining lane.",
#:   "Vehicle 2 was alongside Vehicle 1 in the adjacent lane.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "adjacentLane"]
#: provides = ["AdvAgent", "advLane", "advTrajectory"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: position = "beside"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = -3.0
#: high = 4.5
#: unit = "m"
#: meaning = "how far ahead of the ego it starts"

param OPT_GEO_Y = Range(-3, 4.5)

advTrajectory = extended(adjacentLane, 20)
advLane = advTrajectory
AdvAgent = new AdvClass at pointOn(advTrajectory, 20 + globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, 20 + globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
