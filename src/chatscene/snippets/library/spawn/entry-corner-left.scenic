#: description = "The adversary is on the left front, at the corner where the ego enters the intersection."
#: rephrasings = [
#:   "At the near corner of the junction, on the left.",
#:   "On the left-hand sidewalk, right before the intersection.",
#:   "It waits at the zebra crossing of the ego's arm, left side.",
#:   "The pedestrian stands at the left kerb where the junction begins.",
#:   "The cyclist is on the left front of the ego at the crossing.",
#:   "near left corner of junction",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent"]
#: origin = "base scenario turning-obstacle; own code"
#: [slots]
#: side = "left"
#: position = "roadside"
#: place = "junction"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = -8.0
#: high = -0.5
#: unit = "m"
#: meaning = "how far beyond the start of the intersection it starts, along the ego's route"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 0.4
#: high = 2.5
#: unit = "m"
#: meaning = "how far outside the lanes it starts"

param OPT_GEO_Y = Range(-8, -0.5)
param OPT_GEO_X = Range(0.4, 2.5)

AdvAgent = new AdvClass at besideRoad(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y, "left", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y, "left"),
    with behavior AdvBehavior()
