#: description = "The adversary drives ahead of the ego in the same lane."
#: rephrasings = [
#:   "Right in front of the ego, in its lane.",
#:   "The car leads the ego.",
#:   "It is the vehicle before the ego.",
#:   "Some metres further on in the ego's own lane.",
#:   "The ego follows it.",
#:   "Vehicle 2 preceded Vehicle 1 in the same travel lane.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advTrajectory"]
#: origin = "own code"
#: [slots]
#: position = "ahead"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 9.0
#: high = 22.0
#: unit = "m"
#: meaning = "how far ahead of the ego it starts"

param OPT_GEO_Y = Range(9, 22)

advTrajectory = egoRoute
AdvAgent = new AdvClass at pointOn(advTrajectory, globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
