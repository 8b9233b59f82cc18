#: description = "The adversary is behind the ego in the neighbouring lane."
#: rephrasings = [
#:   "The car starts further back in the neighbouring lane.",
#:   "In the target lane beside, some metres to the rear.",
#:   "It follows the ego, one lane over beside.",
#:   "The other vehicle comes from the rear, in a parallel lane.",
#:   "In the blind spot beside, a few car lengths back.",
#:   "Vehicle 2 was to the rear of Vehicle 1, traveling in the adjacent lane.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "adjacentLane"]
#: provides = ["AdvAgent", "advLane", "advTrajectory"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: position = "behind-beside"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 6.0
#: high = 18.0
#: unit = "m"
#: meaning = "how far behind the ego it starts"

param OPT_GEO_Y = Range(6, 18)

advTrajectory = extended(adjacentLane, 20)
advLane = advTrajectory
AdvAgent = new AdvClass at pointOn(advTrajectory, 20 - globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, 20 - globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
