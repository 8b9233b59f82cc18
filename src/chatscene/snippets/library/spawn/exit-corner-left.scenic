#: description = "The adversary is on the opposite sidewalk, at the left side of the road the ego drives into."
#: rephrasings = [
#:   "At the far corner of the junction, on the left.",
#:   "On the pavement beyond the intersection, left front.",
#:   "It waits across the junction, to the left of the exit.",
#:   "The pedestrian stands at the opposite kerb, left of the ego's way out.",
#:   "Past the crossing, at the left-hand corner.",
#:   "on the left just after we've gone through the junction",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute", "junctionExit"]
#: provides = ["AdvAgent"]
#: origin = "base scenario turning-obstacle; own code"
#: [slots]
#: side = "left"
#: position = "far-corner"
#: place = "junction"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = -2.0
#: high = 6.0
#: unit = "m"
#: meaning = "how far beyond the intersection it starts, along the ego's route"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 0.4
#: high = 2.5
#: unit = "m"
#: meaning = "how far outside the lanes it starts"

param OPT_GEO_Y = Range(-2, 6)
param OPT_GEO_X = Range(0.4, 2.5)

AdvAgent = new AdvClass at besideRoad(egoRoute, junctionExit + globalParameters.OPT_GEO_Y, "left", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, junctionExit + globalParameters.OPT_GEO_Y, "left"),
    with behavior AdvBehavior()
