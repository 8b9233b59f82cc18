#: description = "The adversary is on the right front, at the corner where the ego enters the intersection."
#: rephrasings = [
#:   "At the near corner of the junction, on the right.",
#:   "On the right-hand sidewalk, right before the intersection.",
#:   "It waits at the zebra crossing of the ego's arm, right side.",
#:   "The pedestrian stands at the right kerb where the junction begins.",
#:   "The cyclist is on the right front of the ego at the crossing.",
#:   "The non-motorist stood at the near right corner of the intersection.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent"]
#: origin = "base scenario turning-obstacle; own code"
#: [slots]
#: side = "right"
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
#: low = 1.2
#: high = 4.0
#: unit = "m"
#: meaning = "how far outside the lanes it starts"

param OPT_GEO_Y = Range(-8, -0.5)
param OPT_GEO_X = Range(1.2, 4)

AdvAgent = new AdvClass at besideRoad(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y, "right", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y, "right"),
    with behavior AdvBehavior()
