#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: origin = "own code"
#: [slots]
#: position = "roadside"
#: place = "junction"
#: [variants]
#: entry-corner-left             = { side = "left", y = [-8, -0.5], x = [0.4, 2.5], origin = "base scenario turning-obstacle; own code" }
#: entry-corner-left-billboard   = { side = "left", y = [-7, -0.5], x = [2.2, 2.8], occluder = "billboard", gap = [2, 2.7], Thing = "Billboard", out = 1.5 }
#: entry-corner-left-group       = { side = "left", y = [-8, -2.5], x = [0.6, 2.4], group = true }
#: entry-corner-left-hedge       = { side = "left", y = [-7, -0.5], x = [1.8, 2.6], occluder = "hedge", gap = [3.1, 3.9], Thing = "Hedge", out = 1.2 }
#: entry-corner-right            = { side = "right", y = [-8, -0.5], x = [1.2, 4], origin = "base scenario turning-obstacle; own code" }
#: entry-corner-right-group      = { side = "right", y = [-8, -2.5], x = [0.6, 2.4], group = true }
#: entry-corner-right-hedge      = { side = "right", y = [-7, -0.5], x = [1.4, 2.2], occluder = "hedge", gap = [3.1, 3.9], Thing = "Hedge", out = 1.2 }
#: entry-corner-right-parked-car = { side = "right", y = [-7, -0.5], x = [1, 2.3], occluder = "parked-car", gap = [3.4, 5.1], Thing = "Car", out = 1.2 }
#: [descriptions]
#: entry-corner-left             = "The adversary is on the left front, at the corner where the ego enters the intersection."
#: entry-corner-left-billboard   = "The adversary is hidden by a billboard at the left corner where the ego enters the intersection."
#: entry-corner-left-group       = "A group stands at the left corner where the ego enters the intersection, the adversary at its front."
#: entry-corner-left-hedge       = "The adversary is hidden by a hedge at the left corner where the ego enters the intersection."
#: entry-corner-right            = "The adversary is on the right front, at the corner where the ego enters the intersection."
#: entry-corner-right-group      = "A group stands at the right corner where the ego enters the intersection, the adversary at its front."
#: entry-corner-right-hedge      = "The adversary is hidden by a hedge at the right corner where the ego enters the intersection."
#: entry-corner-right-parked-car = "The adversary is hidden by a parked car at the right corner where the ego enters the intersection."

param OPT_GEO_Y = Range$y  #: [m] how far beyond the start of the intersection it starts, along the ego's route
param OPT_GEO_X = Range$x  #: [m] how far outside the lanes it starts
param OPT_BLOCKER_GAP = Range$gap  #: if occluder  #: [m] how far before it, along the road, the middle of what hides it stands

new $Thing at besideRoad(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y, "$side", $out) offset along directionOn(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y) by 0 @ -globalParameters.OPT_BLOCKER_GAP,  #: if occluder
    facing directionOn(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y),  #: if occluder
    with label "$occluder"  #: if occluder
AdvAgent = new AdvClass at besideRoad(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y, "$side", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y, "$side"),
    with behavior AdvBehavior()
new AdvClass at besideRoad(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y + 1.3, "$side", globalParameters.OPT_GEO_X + 0.5),  #: if group
    facing crossingDirection(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y + 1.3, "$side"),  #: if group
    with behavior AdvBehavior()  #: if group
new AdvClass at besideRoad(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y - 1.2, "$side", globalParameters.OPT_GEO_X + 0.9),  #: if group
    facing crossingDirection(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y - 1.2, "$side"),  #: if group
    with behavior AdvBehavior()  #: if group
