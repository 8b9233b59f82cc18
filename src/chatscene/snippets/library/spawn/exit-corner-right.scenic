#: description = "The adversary is on the opposite sidewalk, at the right side of the road the ego drives into."
#: rephrasings = [
#:   "At the far corner of the junction, on the right.",
#:   "On the pavement beyond the intersection, right front.",
#:   "It waits across the junction, to the right of the exit.",
#:   "The pedestrian stands at the opposite kerb, right of the ego's way out.",
#:   "Past the crossing, at the right-hand corner.",
#:   "far right corner of junction, exit leg",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute", "junctionExit"]
#: provides = ["AdvAgent"]
#: origin = "base scenario turning-obstacle; own code"
#: [slots]
#: side = "right"
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
#: low = 1.2
#: high = 4.0
#: unit = "m"
#: meaning = "how far outside the lanes it starts"

param OPT_GEO_Y = Range(-2, 6)
param OPT_GEO_X = Range(1.2, 4)

AdvAgent = new AdvClass at besideRoad(egoRoute, junctionExit + globalParameters.OPT_GEO_Y, "right", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, junctionExit + globalParameters.OPT_GEO_Y, "right"),
    with behavior AdvBehavior()
