#: description = "The adversary is behind a parked truck on the right front."
#: rephrasings = [
#:   "A lorry standing at the right kerb conceals it.",
#:   "Hidden by a delivery van or truck, right side of the road.",
#:   "Out of sight in front of a big stationary lorry on the right.",
#:   "The ego's view is blocked by a truck parked ahead, right.",
#:   "It is about to emerge from beyond a halted lorry at the right edge.",
#:   "The target is obstructed by a goods vehicle at rest on the nearside.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advLevel"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: side = "right"
#: position = "roadside"
#: occluder = "parked-truck"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 22.0
#: high = 50.0
#: unit = "m"
#: meaning = "how far along the ego's route it starts"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 1.0
#: high = 2.5
#: unit = "m"
#: meaning = "how far outside the lanes it starts"
#: [[parameters]]
#: name = "OPT_BLOCKER_GAP"
#: low = 4.8
#: high = 6.5
#: unit = "m"
#: meaning = "how far before it, along the road, the middle of what hides it stands"

param OPT_GEO_Y = Range(22, 50)
param OPT_GEO_X = Range(1, 2.5)
param OPT_BLOCKER_GAP = Range(4.8, 6.5)

# Not in the middle of an intersection, where the side of the road would be far away.
advLevel = shortOfJunction(egoRoute, globalParameters.OPT_GEO_Y)
new Truck at besideRoad(egoRoute, advLevel - globalParameters.OPT_BLOCKER_GAP, "right", 1.35),
    facing directionOn(egoRoute, advLevel - globalParameters.OPT_BLOCKER_GAP),
    with label "parked-truck"
AdvAgent = new AdvClass at besideRoad(egoRoute, advLevel, "right", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, advLevel, "right"),
    with behavior AdvBehavior()
