#: description = "The adversary comes toward the ego on foot along the left edge of the road."
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: side = "left"
#: position = "oncoming"

param OPT_GEO_Y = Range(28, 55)  #: [m] how far ahead of the ego it starts
param OPT_GEO_X = Range(0, 1.2)  #: [m] how far outside the lanes it starts

# Not in the middle of an intersection, where the side of the road would be far away.
advLevel = shortOfJunction(egoRoute, globalParameters.OPT_GEO_Y)
AdvAgent = new AdvClass at besideRoad(egoRoute, advLevel, "left", globalParameters.OPT_GEO_X),
    facing directionOn(egoRoute, advLevel, advFacing),
    with behavior AdvBehavior()
