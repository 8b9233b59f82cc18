#: description = "The adversary is hidden behind a vending machine on the $side front."
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: position = "roadside"
#: occluder = "vending-machine"
#: [variants]
#: behind-vending-machine-left  = { side = "left", y = [30, 52], x = [1.5, 2.2], gap = [1.5, 2.3] }
#: behind-vending-machine-right = { side = "right", y = [22, 50], x = [1.5, 2.2], gap = [1.5, 2.3] }

param OPT_GEO_Y = Range$y  #: [m] how far along the ego's route it starts
param OPT_GEO_X = Range$x  #: [m] how far outside the lanes it starts
param OPT_BLOCKER_GAP = Range$gap  #: [m] how far before it, on the line of sight from the ego, the middle of what hides it stands

# Not in the middle of an intersection, where the side of the road would be far away.
advLevel = shortOfJunction(egoRoute, globalParameters.OPT_GEO_Y)
# On the line of sight of an ego that is some way off, in bends too.
new VendingMachine at besideRoad(egoRoute, advLevel, "$side", globalParameters.OPT_GEO_X) offset along (angle from besideRoad(egoRoute, advLevel, "$side", globalParameters.OPT_GEO_X) to pointOn(egoRoute, advLevel - 25)) by 0 @ globalParameters.OPT_BLOCKER_GAP,
    facing directionOn(egoRoute, advLevel),
    with label "vending-machine"
AdvAgent = new AdvClass at besideRoad(egoRoute, advLevel, "$side", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, advLevel, "$side"),
    with behavior AdvBehavior()
