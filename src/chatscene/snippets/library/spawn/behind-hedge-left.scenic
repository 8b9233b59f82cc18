#: description = "The adversary is behind a hedge on the left front."
#: rephrasings = [
#:   "Concealed by bushes along the left edge of the road.",
#:   "some kid behind the hedge on the left, no chance to see him",
#:   "occluded by hedge / fence / wall, left side",
#:   "Vegetation on the left roadside restricted the sight line to the non-motorist.",
#:   "The target is obstructed by a continuous wall or planting on the offside side.",
#:   "He hides after the green bushes or the garden wall on left side.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advLevel"]
#: origin = "own code"
#: [slots]
#: side = "left"
#: position = "roadside"
#: occluder = "hedge"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 30.0
#: high = 52.0
#: unit = "m"
#: meaning = "how far along the ego's route it starts"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 1.8
#: high = 2.6
#: unit = "m"
#: meaning = "how far outside the lanes it starts"
#: [[parameters]]
#: name = "OPT_BLOCKER_GAP"
#: low = 3.1
#: high = 3.9
#: unit = "m"
#: meaning = "how far before it, along the road, the middle of what hides it stands"

param OPT_GEO_Y = Range(30, 52)
param OPT_GEO_X = Range(1.8, 2.6)
param OPT_BLOCKER_GAP = Range(3.1, 3.9)

# Not in the middle of an intersection, where the side of the road would be far away.
advLevel = shortOfJunction(egoRoute, globalParameters.OPT_GEO_Y)
new Hedge at besideRoad(egoRoute, advLevel, "left", 1.2) offset along directionOn(egoRoute, advLevel) by 0 @ -globalParameters.OPT_BLOCKER_GAP,
    facing directionOn(egoRoute, advLevel),
    with label "hedge"
AdvAgent = new AdvClass at besideRoad(egoRoute, advLevel, "left", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, advLevel, "left"),
    with behavior AdvBehavior()
