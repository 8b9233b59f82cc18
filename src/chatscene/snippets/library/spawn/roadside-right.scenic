#: description = "The adversary stands at the right side of the road ahead of the ego."
#: rephrasings = [
#:   "On the right front, next to the carriageway.",
#:   "At the right kerb, some way before the ego.",
#:   "The pedestrian waits on the right-hand pavement.",
#:   "Beside the street, to the right and ahead.",
#:   "It appears from a driveway on the right.",
#:   "The cyclist is at the edge of the roadway, right front.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advLevel"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: side = "right"
#: position = "roadside"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 22.0
#: high = 50.0
#: unit = "m"
#: meaning = "how far along the ego's route it starts"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 1.2
#: high = 5.0
#: unit = "m"
#: meaning = "how far outside the lanes it starts"

param OPT_GEO_Y = Range(22, 50)
param OPT_GEO_X = Range(1.2, 5)

# Not in the middle of an intersection, where the side of the road would be far away.
advLevel = shortOfJunction(egoRoute, globalParameters.OPT_GEO_Y)
AdvAgent = new AdvClass at besideRoad(egoRoute, advLevel, "right", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, advLevel, "right"),
    with behavior AdvBehavior()
