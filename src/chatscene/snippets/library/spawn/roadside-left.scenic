#: description = "The adversary stands at the left side of the road ahead of the ego."
#: rephrasings = [
#:   "On the left front, next to the carriageway.",
#:   "At the left kerb, some way before the ego.",
#:   "The pedestrian waits on the left-hand pavement.",
#:   "Beside the street, to the left and ahead.",
#:   "It appears from a driveway on the left.",
#:   "The cyclist is at the edge of the roadway, left front.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advLevel"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: side = "left"
#: position = "roadside"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 30.0
#: high = 52.0
#: unit = "m"
#: meaning = "how far along the ego's route it starts"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 0.6
#: high = 3.0
#: unit = "m"
#: meaning = "how far outside the lanes it starts"

param OPT_GEO_Y = Range(30, 52)
param OPT_GEO_X = Range(0.6, 3)

# Not in the middle of an intersection, where the side of the road would be far away.
advLevel = shortOfJunction(egoRoute, globalParameters.OPT_GEO_Y)
AdvAgent = new AdvClass at besideRoad(egoRoute, advLevel, "left", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, advLevel, "left"),
    with behavior AdvBehavior()
