#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: position = "roadside"
#: [variants]
#: roadside-left        = { side = "left", y = [30, 52], x = [0.6, 3] }
#: roadside-right       = { side = "right", y = [22, 50], x = [1.2, 5] }
#: roadside-left-group  = { side = "left", y = [28, 46], x = [0.8, 2.6], group = true, origin = "own code" }
#: roadside-right-group = { side = "right", y = [20, 46], x = [0.8, 2.6], group = true, origin = "own code" }
#: [descriptions]
#: roadside-left        = "The adversary stands at the left side of the road ahead of the ego."
#: roadside-right       = "The adversary stands at the right side of the road ahead of the ego."
#: roadside-left-group  = "A group waits at the left side of the road ahead, the adversary at its front."
#: roadside-right-group = "A group waits at the right side of the road ahead, the adversary at its front."

param OPT_GEO_Y = Range$y  #: [m] how far along the ego's route it starts
param OPT_GEO_X = Range$x  #: [m] how far outside the lanes it starts

# Not in the middle of an intersection, where the side of the road would be far away.
advLevel = shortOfJunction(egoRoute, globalParameters.OPT_GEO_Y)
AdvAgent = new AdvClass at besideRoad(egoRoute, advLevel, "$side", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, advLevel, "$side"),
    with behavior AdvBehavior()
new AdvClass at besideRoad(egoRoute, advLevel + 1.6, "$side", globalParameters.OPT_GEO_X + 0.5),  #: if group
    facing crossingDirection(egoRoute, advLevel + 1.6, "$side"),  #: if group
    with behavior AdvBehavior()  #: if group
new AdvClass at besideRoad(egoRoute, advLevel - 1.5, "$side", globalParameters.OPT_GEO_X + 0.9),  #: if group
    facing crossingDirection(egoRoute, advLevel - 1.5, "$side"),  #: if group
    with behavior AdvBehavior()  #: if group
