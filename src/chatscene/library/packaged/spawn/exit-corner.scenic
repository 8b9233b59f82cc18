#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: origin = "base scenario turning-obstacle; own code"
#: [slots]
#: position = "far-corner"
#: place = "junction"
#: [variants]
#: exit-corner-left        = { side = "left", y = [-2, 6], x = [0.4, 2.5] }
#: exit-corner-left-group  = { side = "left", y = [0, 8], x = [0.5, 2.4], group = true, origin = "own code" }
#: exit-corner-right       = { side = "right", y = [-2, 6], x = [1.2, 4] }
#: exit-corner-right-group = { side = "right", y = [0, 8], x = [0.5, 2.4], group = true, origin = "own code" }
#: [descriptions]
#: exit-corner-left        = "The adversary is on the opposite sidewalk, at the left side of the road the ego drives into."
#: exit-corner-left-group  = "A group stands at the left side of the road that the ego drives into, the adversary at its front."
#: exit-corner-right       = "The adversary is on the opposite sidewalk, at the right side of the road the ego drives into."
#: exit-corner-right-group = "A group stands at the right side of the road that the ego drives into, the adversary at its front."

param OPT_GEO_Y = Range$y  #: [m] how far beyond the end of the intersection it starts, along the ego's route
param OPT_GEO_X = Range$x  #: [m] how far outside the lanes it starts

AdvAgent = new AdvClass at besideRoad(egoRoute, junctionExit + globalParameters.OPT_GEO_Y, "$side", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, junctionExit + globalParameters.OPT_GEO_Y, "$side"),
    with behavior AdvBehavior()
new AdvClass at besideRoad(egoRoute, junctionExit + globalParameters.OPT_GEO_Y + 1.3, "$side", globalParameters.OPT_GEO_X + 0.5),  #: if group
    facing crossingDirection(egoRoute, junctionExit + globalParameters.OPT_GEO_Y + 1.3, "$side"),  #: if group
    with behavior AdvBehavior()  #: if group
new AdvClass at besideRoad(egoRoute, junctionExit + globalParameters.OPT_GEO_Y - 1.2, "$side", globalParameters.OPT_GEO_X + 0.9),  #: if group
    facing crossingDirection(egoRoute, junctionExit + globalParameters.OPT_GEO_Y - 1.2, "$side"),  #: if group
    with behavior AdvBehavior()  #: if group
