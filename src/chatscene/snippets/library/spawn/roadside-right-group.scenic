#: description = "A group waits at the right side of the road ahead, the adversary at its front."
#: rephrasings = [
#:   "Several people together on the right pavement.",
#:   "a bunch of school kids hanging about on the right",
#:   "group of peds / cyclists, right road edge",
#:   "Three non-motorists were gathered at the right edge of the roadway ahead of Vehicle 1.",
#:   "The target is accompanied by two more of its kind on the nearside pavement.",
#:   "Some friends stay together on right side of the street, before the ego.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advLevel"]
#: origin = "own code"
#: [slots]
#: side = "right"
#: position = "roadside"
#: group = true
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 20.0
#: high = 46.0
#: unit = "m"
#: meaning = "how far along the ego's route it starts"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 0.8
#: high = 2.6
#: unit = "m"
#: meaning = "how far outside the lanes it starts"

param OPT_GEO_Y = Range(20, 46)
param OPT_GEO_X = Range(0.8, 2.6)

# Not in the middle of an intersection, where the side of the road would be far away.
advLevel = shortOfJunction(egoRoute, globalParameters.OPT_GEO_Y)
AdvAgent = new AdvClass at besideRoad(egoRoute, advLevel, "right", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, advLevel, "right"),
    with behavior AdvBehavior()
new AdvClass at besideRoad(egoRoute, advLevel + 1.3, "right", globalParameters.OPT_GEO_X + 0.5),
    facing crossingDirection(egoRoute, advLevel + 1.3, "right"),
    with behavior AdvBehavior()
new AdvClass at besideRoad(egoRoute, advLevel - 1.2, "right", globalParameters.OPT_GEO_X + 0.9),
    facing crossingDirection(egoRoute, advLevel - 1.2, "right"),
    with behavior AdvBehavior()
