#: description = "The adversary is behind a container on the right front."
#: rephrasings = [
#:   "A dumpster at the right kerb conceals it.",
#:   "Hidden by a skip, right of the carriageway.",
#:   "Out of sight in back of a big rubbish container on the right.",
#:   "The ego's view is blocked by a waste bin ahead, right.",
#:   "It stands beyond a construction container at the right edge.",
#:   "there's a skip on our right and someone behind it",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advLevel"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: side = "right"
#: position = "roadside"
#: occluder = "container"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 22.0
#: high = 50.0
#: unit = "m"
#: meaning = "how far along the ego's route it starts"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 1.7
#: high = 2.7
#: unit = "m"
#: meaning = "how far outside the lanes it starts"
#: [[parameters]]
#: name = "OPT_BLOCKER_GAP"
#: low = 2.4
#: high = 4.1
#: unit = "m"
#: meaning = "how far before it, along the road, the middle of what hides it stands"

param OPT_GEO_Y = Range(22, 50)
param OPT_GEO_X = Range(1.7, 2.7)
param OPT_BLOCKER_GAP = Range(2.4, 4.1)

# Not in the middle of an intersection, where the side of the road would be far away.
advLevel = shortOfJunction(egoRoute, globalParameters.OPT_GEO_Y)
new Container at besideRoad(egoRoute, advLevel - globalParameters.OPT_BLOCKER_GAP, "right", 1.8),
    facing directionOn(egoRoute, advLevel - globalParameters.OPT_BLOCKER_GAP),
    with label "container"
AdvAgent = new AdvClass at besideRoad(egoRoute, advLevel, "right", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, advLevel, "right"),
    with behavior AdvBehavior()
