#: description = "The adversary is positioned ahead on the right, at the kerb of the ego's approach."
#: rephrasings = [
#:   "On the right front, pulled over at the edge of the road.",
#:   "A few metres further on, at the right border of the lane.",
#:   "The car stands ahead, a little to the right of the ego.",
#:   "In front and to the right, about to turn as well.",
#:   "Right before the junction it hugs the right-hand kerb, ahead of the ego.",
#:   "The target is ahead of the VUT between its lane and the nearside kerb.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advTrajectory"]
#: origin = "base scenario right-turn; own code"
#: [slots]
#: side = "right"
#: position = "ahead-beside"
#: maneuver = "right-turn"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 8.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far ahead of the ego it starts"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 2.1
#: high = 2.6
#: unit = "m"
#: meaning = "how far to the right of the ego's line it starts"

param OPT_GEO_Y = Range(8, 20)
param OPT_GEO_X = Range(2.1, 2.6)

advTrajectory = egoRoute
AdvAgent = new AdvClass at pointOn(egoRoute, globalParameters.OPT_GEO_Y, -globalParameters.OPT_GEO_X),
    facing directionOn(egoRoute, globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
