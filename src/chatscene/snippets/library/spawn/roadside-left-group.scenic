#: description = "A group waits at the left side of the road ahead, the adversary at its front."
#: rephrasings = [
#:   "Several people together on the left pavement.",
#:   "a bunch of school kids hanging about on the left",
#:   "group of peds / cyclists, left road edge",
#:   "Three non-motorists were gathered at the left edge of the roadway ahead of Vehicle 1.",
#:   "The target is accompanied by two more of its kind on the offside pavement.",
#:   "Some friends stay together on left side of the street, before the ego.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advLevel"]
#: origin = "own code"
#: [slots]
#: side = "left"
#: position = "roadside"
#: group = true
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 28.0
#: high = 46.0
#: unit = "m"
#: meaning = "how far along the ego's route it starts"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 0.8
#: high = 2.6
#: unit = "m"
#: meaning = "how far outside the lanes it starts"

param OPT_GEO_Y = Range(28, 46)
param OPT_GEO_X = Range(0.8, 2.6)

# Not in the middle of an intersection, where the side of the road would be far away.
advLevel = shortOfJunction(egoRoute, globalParameters.OPT_GEO_Y)
AdvAgent = new AdvClass at besideRoad(egoRoute, advLevel, "left", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, advLevel, "left"),
    with behavior AdvBehavior()
new AdvClass at besideRoad(egoRoute, advLevel + 1.3, "left", globalParameters.OPT_GEO_X + 0.5),
    facing crossingDirection(egoRoute, advLevel + 1.3, "left"),
    with behavior AdvBehavior()
new AdvClass at besideRoad(egoRoute, advLevel - 1.2, "left", globalParameters.OPT_GEO_X + 0.9),
    facing crossingDirection(egoRoute, advLevel - 1.2, "left"),
    with behavior AdvBehavior()
