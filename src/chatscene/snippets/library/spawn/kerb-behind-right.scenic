#: description = "The adversary is positioned behind on the right, between the ego and the kerb."
#: rephrasings = [
#:   "On the right rear, at the edge of the road.",
#:   "A few metres back, to the right of the ego.",
#:   "The car comes up from behind on the ego's inner side.",
#:   "Behind and to the right, squeezing along the kerb.",
#:   "In the right-hand blind spot, about to undertake the ego.",
#:   "somebody's sneaking up on the inside, between us and the kerb",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advTrajectory"]
#: origin = "base scenario right-turn; own code"
#: [slots]
#: side = "right"
#: position = "behind-beside"
#: maneuver = "right-turn"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 6.0
#: high = 14.0
#: unit = "m"
#: meaning = "how far behind the ego it starts"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 2.1
#: high = 2.6
#: unit = "m"
#: meaning = "how far to the right of the ego's line it drives"

param OPT_GEO_Y = Range(6, 14)
param OPT_GEO_X = Range(2.1, 2.6)

advTrajectory = extended(egoRoute, 20).offset(-2.3)
AdvAgent = new AdvClass at pointOn(extended(egoRoute, 20), 20 - globalParameters.OPT_GEO_Y, -globalParameters.OPT_GEO_X),
    facing directionOn(extended(egoRoute, 20), 20 - globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
