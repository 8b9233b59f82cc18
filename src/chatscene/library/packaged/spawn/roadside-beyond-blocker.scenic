#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: position = "roadside"
#: maneuver = "bypass"
#: blocker = true
#: [variants]
#: roadside-left-beyond-blocker      = { side = "left", blocker_y = [-3, 3], y = [6.5, 16], x = [0.6, 3.5], Blocker = "Car" }
#: roadside-right-beyond-blocker     = { side = "right", blocker_y = [-3, 3], y = [6.5, 16], x = [0.6, 3.5], Blocker = "Car" }
#: roadside-left-before-stopped-bus  = { side = "left", blocker_y = [-2, 2], y = [9.5, 17], x = [0.4, 2.5], Blocker = "Bus", origin = "passing a stopped bus: pedestrians run out in front of it" }
#: roadside-right-before-stopped-bus = { side = "right", blocker_y = [-2, 2], y = [9.5, 17], x = [0.4, 2.5], Blocker = "Bus", origin = "passing a stopped bus: pedestrians run out in front of it" }
#: [descriptions]
#: roadside-left-beyond-blocker      = "A parked car blocks the ego's lane and the adversary stands at the left side of the road beyond it."
#: roadside-right-beyond-blocker     = "A parked car blocks the ego's lane and the adversary stands at the right side of the road beyond it."
#: roadside-left-before-stopped-bus  = "A stopped bus blocks the ego's lane and the adversary stands at the left side of the road in front of the bus."
#: roadside-right-before-stopped-bus = "A stopped bus blocks the ego's lane and the adversary stands at the right side of the road in front of the bus."

param OPT_BLOCKER_Y = Range$blocker_y  #: [m] how far along the middle of the bypass the parked vehicle stands
param OPT_GEO_Y = Range$y  #: [m] how far beyond the middle of the bypass it starts
param OPT_GEO_X = Range$x  #: [m] how far outside the lanes it starts

new $Blocker at pointOn(blockedLane, egoRoute.eventAt + globalParameters.OPT_BLOCKER_Y),
    facing directionOn(blockedLane, egoRoute.eventAt + globalParameters.OPT_BLOCKER_Y),
    with label "blocker"
AdvAgent = new AdvClass at besideRoad(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y, "$side", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y, "$side"),
    with behavior AdvBehavior()
