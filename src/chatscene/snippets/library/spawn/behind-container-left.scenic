#: description = "The adversary is behind a container on the left front."
#: rephrasings = [
#:   "A dumpster at the left kerb conceals it.",
#:   "Hidden by a skip, left of the carriageway.",
#:   "Out of sight in back of a big rubbish container on the left.",
#:   "The ego's view is blocked by a waste bin ahead, left.",
#:   "It stands beyond a construction container at the left edge.",
#:   "The target is obstructed by a waste container on the offside.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advLevel"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: side = "left"
#: position = "roadside"
#: occluder = "container"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 30.0
#: high = 52.0
#: unit = "m"
#: meaning = "how far along the ego's route it starts"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 2.0
#: high = 2.8
#: unit = "m"
#: meaning = "how far outside the lanes it starts"
#: [[parameters]]
#: name = "OPT_BLOCKER_GAP"
#: low = 2.4
#: high = 4.1
#: unit = "m"
#: meaning = "how far before it, along the road, the middle of what hides it stands"

param OPT_GEO_Y = Range(30, 52)
param OPT_GEO_X = Range(2, 2.8)
param OPT_BLOCKER_GAP = Range(2.4, 4.1)

# Not in the middle of an intersection, where the side of the road would be far away.
advLevel = shortOfJunction(egoRoute, globalParameters.OPT_GEO_Y)
new Container at besideRoad(egoRoute, advLevel - globalParameters.OPT_BLOCKER_GAP, "left", 1.8),
    facing directionOn(egoRoute, advLevel - globalParameters.OPT_BLOCKER_GAP),
    with label "container"
AdvAgent = new AdvClass at besideRoad(egoRoute, advLevel, "left", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, advLevel, "left"),
    with behavior AdvBehavior()
