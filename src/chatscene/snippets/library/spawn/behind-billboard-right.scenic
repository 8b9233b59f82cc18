#: description = "The adversary is behind a billboard on the right front."
#: rephrasings = [
#:   "An advertising board on the right verge covers it.",
#:   "there's an ad column on the right and somebody is standing behind it",
#:   "occluded by billboard, right side",
#:   "A sign board adjacent to the right edge of the roadway blocked the view of the non-motorist.",
#:   "The target is obstructed by an advertising pillar on the nearside pavement.",
#:   "He stays behind the publicity panel on right hand of the road.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advLevel"]
#: origin = "own code"
#: [slots]
#: side = "right"
#: position = "roadside"
#: occluder = "billboard"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 22.0
#: high = 50.0
#: unit = "m"
#: meaning = "how far along the ego's route it starts"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 1.8
#: high = 2.4
#: unit = "m"
#: meaning = "how far outside the lanes it starts"
#: [[parameters]]
#: name = "OPT_BLOCKER_GAP"
#: low = 2.0
#: high = 2.7
#: unit = "m"
#: meaning = "how far before it, along the road, the middle of what hides it stands"

param OPT_GEO_Y = Range(22, 50)
param OPT_GEO_X = Range(1.8, 2.4)
param OPT_BLOCKER_GAP = Range(2, 2.7)

# Not in the middle of an intersection, where the side of the road would be far away.
advLevel = shortOfJunction(egoRoute, globalParameters.OPT_GEO_Y)
new Billboard at besideRoad(egoRoute, advLevel, "right", 1.5) offset along directionOn(egoRoute, advLevel) by 0 @ -globalParameters.OPT_BLOCKER_GAP,
    facing directionOn(egoRoute, advLevel),
    with label "billboard"
AdvAgent = new AdvClass at besideRoad(egoRoute, advLevel, "right", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, advLevel, "right"),
    with behavior AdvBehavior()
