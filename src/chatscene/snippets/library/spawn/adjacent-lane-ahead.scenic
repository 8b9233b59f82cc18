#: description = "The adversary is ahead of the ego in the neighbouring lane."
#: rephrasings = [
#:   "The car starts further on in the neighbouring lane.",
#:   "In the target lane beside, some metres in front.",
#:   "It drives before the ego, one lane over beside.",
#:   "The other vehicle is on the front, in a parallel lane.",
#:   "A few car lengths on, in the lane next to it beside.",
#:   "Vehicle 2 was ahead of Vehicle 1 in the adjacent lane.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "adjacentLane"]
#: provides = ["AdvAgent", "advLane", "advTrajectory"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: position = "ahead-beside"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 6.0
#: high = 22.0
#: unit = "m"
#: meaning = "how far ahead of the ego it starts"

param OPT_GEO_Y = Range(6, 22)

advTrajectory = adjacentLane
advLane = advTrajectory
AdvAgent = new AdvClass at pointOn(advTrajectory, globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
