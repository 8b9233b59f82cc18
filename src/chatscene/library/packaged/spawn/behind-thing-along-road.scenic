#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: position = "roadside"
#: [variants]
#: behind-bus-stop-left        = { side = "left", occluder = "bus-stop", y = [30, 52], x = [1.9, 2.5], gap = [2.7, 4.4], Thing = "BusStop", out = 1.6 }
#: behind-bus-stop-right       = { side = "right", occluder = "bus-stop", y = [22, 50], x = [1.5, 2.3], gap = [2.7, 4.4], Thing = "BusStop", out = 1.6 }
#: behind-bus-stop-right-group = { side = "right", occluder = "bus-stop", y = [22, 50], x = [1.5, 2.3], gap = [2.7, 4], Thing = "BusStop", out = 1.6, group = true, adversaries = ["pedestrian"], origin = "own code" }
#: behind-container-left       = { side = "left", occluder = "container", y = [30, 52], x = [2, 2.8], gap = [2.4, 4.1], Thing = "Container", out = 1.8 }
#: behind-container-right      = { side = "right", occluder = "container", y = [22, 50], x = [1.7, 2.7], gap = [2.4, 4.1], Thing = "Container", out = 1.8 }
#: behind-kiosk-right          = { side = "right", occluder = "kiosk", y = [22, 50], x = [1.6, 2.7], gap = [2.1, 3.8], Thing = "Kiosk", out = 1.8 }
#: behind-parked-car-left      = { side = "left", occluder = "parked-car", y = [30, 52], x = [1.3, 2.5], gap = [3.4, 5.1], Thing = "Car", out = 1.2 }
#: behind-parked-car-right     = { side = "right", occluder = "parked-car", y = [22, 50], x = [1, 2.3], gap = [3.4, 5.1], Thing = "Car", out = 1.2 }
#: behind-parked-truck-right   = { side = "right", occluder = "parked-truck", y = [22, 50], x = [1, 2.5], gap = [4.8, 6.5], Thing = "Truck", out = 1.35 }
#: [descriptions]
#: behind-bus-stop-left        = "The adversary is behind a bus stop on the left front."
#: behind-bus-stop-right       = "The adversary is behind a bus stop on the right front."
#: behind-bus-stop-right-group = "People wait at a bus stop on the right front; the adversary is among them, hidden by the shelter."
#: behind-container-left       = "The adversary is behind a container on the left front."
#: behind-container-right      = "The adversary is behind a container on the right front."
#: behind-kiosk-right          = "The adversary is behind a kiosk on the right front."
#: behind-parked-car-left      = "The adversary is behind a parked car on the left front."
#: behind-parked-car-right     = "The adversary is behind a parked car on the right front."
#: behind-parked-truck-right   = "The adversary is behind a parked truck on the right front."

param OPT_GEO_Y = Range$y  #: [m] how far along the ego's route it starts
param OPT_GEO_X = Range$x  #: [m] how far outside the lanes it starts
param OPT_BLOCKER_GAP = Range$gap  #: [m] how far before it, along the road, the middle of what hides it stands

# Not in the middle of an intersection, where the side of the road would be far away.
advLevel = shortOfJunction(egoRoute, globalParameters.OPT_GEO_Y)
new $Thing at besideRoad(egoRoute, advLevel - globalParameters.OPT_BLOCKER_GAP, "$side", $out),
    facing directionOn(egoRoute, advLevel - globalParameters.OPT_BLOCKER_GAP),
    with label "$occluder"
AdvAgent = new AdvClass at besideRoad(egoRoute, advLevel, "$side", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, advLevel, "$side"),
    with behavior AdvBehavior()
new AdvClass at besideRoad(egoRoute, advLevel + 1.2, "$side", globalParameters.OPT_GEO_X + 0.6),  #: if group
    facing crossingDirection(egoRoute, advLevel + 1.2, "$side"),  #: if group
    with behavior AdvBehavior()  #: if group
new AdvClass at besideRoad(egoRoute, advLevel + 2.4, "$side", globalParameters.OPT_GEO_X),  #: if group
    facing crossingDirection(egoRoute, advLevel + 2.4, "$side"),  #: if group
    with behavior AdvBehavior()  #: if group
