#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: origin = "own code"
#: [slots]
#: position = "roadside"
#: [variants]
#: behind-billboard-left    = { side = "left", occluder = "billboard", y = [30, 52], x = [2.2, 2.8], gap = [2, 2.7], Thing = "Billboard", out = 1.5 }
#: behind-billboard-right   = { side = "right", occluder = "billboard", y = [22, 50], x = [1.8, 2.4], gap = [2, 2.7], Thing = "Billboard", out = 1.5 }
#: behind-hedge-left        = { side = "left", occluder = "hedge", y = [30, 52], x = [1.8, 2.6], gap = [3.1, 3.9], Thing = "Hedge", out = 1.2 }
#: behind-hedge-right       = { side = "right", occluder = "hedge", y = [22, 50], x = [1.4, 2.2], gap = [3.1, 3.9], Thing = "Hedge", out = 1.2 }
#: behind-kiosk-left        = { side = "left", occluder = "kiosk", y = [30, 52], x = [1.9, 2.8], gap = [2, 2.9], Thing = "Kiosk", out = 1.7 }
#: behind-parked-bus-left   = { side = "left", occluder = "parked-bus", y = [30, 52], x = [1.7, 2.8], gap = [7.1, 8.2], Thing = "Bus", out = 1.35 }
#: behind-parked-bus-right  = { side = "right", occluder = "parked-bus", y = [22, 50], x = [1, 2.5], gap = [7.1, 8.2], Thing = "Bus", out = 1.35 }
#: behind-parked-truck-left = { side = "left", occluder = "parked-truck", y = [30, 52], x = [1.7, 2.8], gap = [5.2, 6.4], Thing = "Truck", out = 1.35 }
#: [descriptions]
#: behind-billboard-left    = "The adversary is behind a billboard on the left front."
#: behind-billboard-right   = "The adversary is behind a billboard on the right front."
#: behind-hedge-left        = "The adversary is behind a hedge on the left front."
#: behind-hedge-right       = "The adversary is behind a hedge on the right front."
#: behind-kiosk-left        = "The adversary is behind a kiosk on the left front."
#: behind-parked-bus-left   = "The adversary is behind a parked bus on the left front."
#: behind-parked-bus-right  = "The adversary is behind a parked bus on the right front."
#: behind-parked-truck-left = "The adversary is behind a parked truck on the left front."

param OPT_GEO_Y = Range$y  #: [m] how far along the ego's route it starts
param OPT_GEO_X = Range$x  #: [m] how far outside the lanes it starts
param OPT_BLOCKER_GAP = Range$gap  #: [m] how far before it, along the road, the middle of what hides it stands

# Not in the middle of an intersection, where the side of the road would be far away.
advLevel = shortOfJunction(egoRoute, globalParameters.OPT_GEO_Y)
new $Thing at besideRoad(egoRoute, advLevel, "$side", $out) offset along directionOn(egoRoute, advLevel) by 0 @ -globalParameters.OPT_BLOCKER_GAP,
    facing directionOn(egoRoute, advLevel),
    with label "$occluder"
AdvAgent = new AdvClass at besideRoad(egoRoute, advLevel, "$side", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, advLevel, "$side"),
    with behavior AdvBehavior()
