#: description = "A group stands at the left corner where the ego enters the intersection, the adversary at its front."
#: rephrasings = [
#:   "Several pedestrians at the near left corner of the crossing.",
#:   "a few people waiting on the corner to our left, just before the junction",
#:   "group, near left corner of junction",
#:   "Three non-motorists were waiting on the left near-side corner of the intersection.",
#:   "The target with companions is located at the left corner of the approach.",
#:   "Many people stay in the left corner before the crossing.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent"]
#: origin = "own code"
#: [slots]
#: side = "left"
#: position = "roadside"
#: place = "junction"
#: group = true
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = -8.0
#: high = -2.5
#: unit = "m"
#: meaning = "how far beyond the start of the intersection it starts, along the ego's route"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 0.6
#: high = 2.4
#: unit = "m"
#: meaning = "how far outside the lanes it starts"

param OPT_GEO_Y = Range(-8, -2.5)
param OPT_GEO_X = Range(0.6, 2.4)

AdvAgent = new AdvClass at besideRoad(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y, "left", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y, "left"),
    with behavior AdvBehavior()
new AdvClass at besideRoad(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y + 1.3, "left", globalParameters.OPT_GEO_X + 0.5),
    facing crossingDirection(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y + 1.3, "left"),
    with behavior AdvBehavior()
new AdvClass at besideRoad(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y - 1.2, "left", globalParameters.OPT_GEO_X + 0.9),
    facing crossingDirection(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y - 1.2, "left"),
    with behavior AdvBehavior()
