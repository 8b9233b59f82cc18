#: description = "The adversary comes toward the ego on foot along the left edge of the road."
#: rephrasings = [
#:   "A person walks against the traffic beside the carriageway.",
#:   "Someone approaches from ahead at the road's left border.",
#:   "Facing the ego, on the verge to its left.",
#:   "The jogger comes the other way next to the street.",
#:   "An oncoming pedestrian at the edge of the roadway.",
#:   "The pedestrian was walking along the left edge of the roadway, facing traffic.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "advFacing", "egoRoute"]
#: provides = ["AdvAgent", "advLevel"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: position = "oncoming"
#: side = "left"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 28.0
#: high = 55.0
#: unit = "m"
#: meaning = "how far ahead of the ego it starts"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 0.0
#: high = 1.2
#: unit = "m"
#: meaning = "how far outside the lanes it starts"

param OPT_GEO_Y = Range(28, 55)
param OPT_GEO_X = Range(0, 1.2)

# Not in the middle of an intersection, where the side of the road would be far away.
advLevel = shortOfJunction(egoRoute, globalParameters.OPT_GEO_Y)
AdvAgent = new AdvClass at besideRoad(egoRoute, advLevel, "left", globalParameters.OPT_GEO_X),
    facing directionOn(egoRoute, advLevel, advFacing),
    with behavior AdvBehavior()
