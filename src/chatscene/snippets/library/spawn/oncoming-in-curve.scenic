#: description = "The adversary comes toward the ego in the oncoming lane of the bend."
#: rephrasings = [
#:   "Round the curve, in the opposite lane, toward the ego.",
#:   "something's coming round the bend at us",
#:   "opposing lane, in curve",
#:   "Vehicle 2 was negotiating the curve in the opposite direction.",
#:   "The target approaches through the bend in the opposing lane.",
#:   "From the other end of the curve, against the ego in its lane.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "egoRoute", "oppositeLane"]
#: provides = ["AdvAgent", "advTrajectory"]
#: origin = "own code"
#: [slots]
#: position = "oncoming"
#: place = "curve"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 26.0
#: high = 40.0
#: unit = "m"
#: meaning = "how far ahead of the ego it starts"

param OPT_GEO_Y = Range(26, 40)

advTrajectory = oppositeLane
AdvAgent = new AdvClass at pointOn(advTrajectory, levelOn(advTrajectory, egoRoute, globalParameters.OPT_GEO_Y)),
    facing directionOn(advTrajectory, levelOn(advTrajectory, egoRoute, globalParameters.OPT_GEO_Y)),
    with behavior AdvBehavior()
