#: description = "The adversary drives behind the ego in the same lane."
#: rephrasings = [
#:   "Following the vehicle under test from a few metres back.",
#:   "The car is right at the rear bumper.",
#:   "It tailgates the slower vehicle before it.",
#:   "Some metres to the rear, on the very path that was just driven.",
#:   "A pursuer comes up from the back with no lane between them.",
#:   "Vehicle 2 was following Vehicle 1 in the same travel lane.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"]
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
