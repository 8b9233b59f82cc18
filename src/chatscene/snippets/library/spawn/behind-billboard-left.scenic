#: description = "The adversary is behind a billboard on the left front."
#: rephrasings = [
#:   "An advertising board on the left verge covers it.",
#:   "there's an ad column on the left and somebody is standing behind it",
#:   "occluded by billboard, left side",
#:   "A sign board adjacent to the left edge of the roadway blocked the view of the non-motorist.",
#:   "The target is obstructed by an advertising pillar on the offside pavement.",
#:   "He stays behind the publicity panel on left hand of the road.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advLevel"]
#: origin = "own code"
#: [slots]
#: side = "left"
#: position = "roadside"
#: occluder = "billboard"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 30.0
#: high = 52.0
#: unit = "m"
#: meaning = "how far along the ego's route it starts"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 2.2
#: high = 2.8
#: unit = "m"
#: meaning = "how far outside the lanes it starts"
#: [[parameters]]
#: name = "OPT_BLOCKER_GAP"
#: low = 2.0
#: high = 2.7
#: unit = "m"
#: meaning = "how far before it, along the road, the middle of what hides it stands"

param OPT_GEO_Y = Range(30, 52)
param OPT_GEO_X = Range(2.2, 2.8)
param OPT_BLOCKER_GAP = Range(2, 2.7)

# Not in the middle of an intersection, where the side of the road would be far away.
advLevel = shortOfJunction(egoRoute, globalParameters.OPT_GEO_Y)
new Billboard at besideRoad(egoRoute, advLevel, "left", 1.5) offset along directionOn(egoRoute, advLevel) by 0 @ -globalParameters.OPT_BLOCKER_GAP,
    facing directionOn(egoRoute, advLevel),
    with label "billboard"
AdvAgent = new AdvClass at besideRoad(egoRoute, advLevel, "left", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, advLevel, "left"),
    with behavior AdvBehavior()
