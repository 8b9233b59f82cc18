#: description = "A group stands at the left side of the road that the ego drives into, the adversary at its front."
#: rephrasings = [
#:   "Several people at the far left corner, where the ego leaves the intersection.",
#:   "a little crowd on the left just after the junction",
#:   "group, far left corner, exit leg",
#:   "Three non-motorists were gathered on the left of the exit leg of the intersection.",
#:   "The target with companions is located left of the arm into which the VUT drives.",
#:   "Many people stay on left hand of the street in which the ego comes after the crossing.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute", "junctionExit"]
#: provides = ["AdvAgent"]
#: origin = "own code"
#: [slots]
#: side = "left"
#: position = "far-corner"
#: place = "junction"
#: group = true
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 0.0
#: high = 8.0
#: unit = "m"
#: meaning = "how far beyond the end of the intersection it starts, along the ego's route"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 0.5
#: high = 2.4
#: unit = "m"
#: meaning = "how far outside the lanes it starts"

param OPT_GEO_Y = Range(0, 8)
param OPT_GEO_X = Range(0.5, 2.4)

AdvAgent = new AdvClass at besideRoad(egoRoute, junctionExit + globalParameters.OPT_GEO_Y, "left", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, junctionExit + globalParameters.OPT_GEO_Y, "left"),
    with behavior AdvBehavior()
new AdvClass at besideRoad(egoRoute, junctionExit + globalParameters.OPT_GEO_Y + 1.3, "left", globalParameters.OPT_GEO_X + 0.5),
    facing crossingDirection(egoRoute, junctionExit + globalParameters.OPT_GEO_Y + 1.3, "left"),
    with behavior AdvBehavior()
new AdvClass at besideRoad(egoRoute, junctionExit + globalParameters.OPT_GEO_Y - 1.2, "left", globalParameters.OPT_GEO_X + 0.9),
    facing crossingDirection(egoRoute, junctionExit + globalParameters.OPT_GEO_Y - 1.2, "left"),
    with behavior AdvBehavior()
