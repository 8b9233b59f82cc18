#: description = "The adversary is ahead of the ego in the lane to the right of the ego."
#: rephrasings = [
#:   "The car starts further on in the lane to the right of the ego.",
#:   "In the target lane on the right, some metres in front.",
#:   "It drives before the ego, one lane over on the right.",
#:   "The other vehicle is on the right front, in a parallel lane.",
#:   "A few car lengths on, in the lane next to it on the right.",
#:   "Vehicle 2 was ahead of Vehicle 1 in the lane on the right.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "rightLane"]
#: provides = ["AdvAgent", "advLane", "advTrajectory"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: position = "ahead-beside"
#: side = "right"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 6.0
#: high = 22.0
#: unit = "m"
#: meaning = "how far ahead of the ego it starts"

param OPT_GEO_Y = Range(6, 22)

advTrajectory = rightLane
advLane = advTrajectory
AdvAgent = new AdvClass at pointOn(advTrajectory, globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
