#: description = "The adversary drives behind the ego in the same lane."
#: rephrasings = [
#:   "Following the ego in its lane.",
#:   "The car is at the ego's rear.",
#:   "It tailgates the ego.",
#:   "Some metres back, in the ego's own lane.",
#:   "The ego is in front of it.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advTrajectory"]
#: origin = "own code"
#: [slots]
#: position = "behind"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 8.0
#: high = 18.0
#: unit = "m"
#: meaning = "how far behind the ego it starts"

param OPT_GEO_Y = Range(8, 18)

advTrajectory = extended(egoRoute, 20)
AdvAgent = new AdvClass at pointOn(advTrajectory, 20 - globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, 20 - globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
