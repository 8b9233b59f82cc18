#: description = "The adversary stands between two parked cars on the $side front."
#: adversaries = ["pedestrian", "bicycle"]
#: origin = "Euro NCAP CPNCO: a child between parked cars"
#: [slots]
#: position = "roadside"
#: occluder = "parked-car"
#: place = "road"
#: [variants]
#: between-parked-cars-left  = { side = "left", y = [30, 52], x = [1.3, 2], gap = [3.6, 4.2] }
#: between-parked-cars-right = { side = "right", y = [22, 50], x = [0.8, 1.6], gap = [3.6, 4.2] }

param OPT_GEO_Y = Range$y  #: [m] how far along the ego's route it starts
param OPT_GEO_X = Range$x  #: [m] how far outside the lanes it starts
param OPT_BLOCKER_GAP = Range$gap  #: [m] how far before and behind it the middles of the two cars stand

new Car at besideRoad(egoRoute, globalParameters.OPT_GEO_Y, "$side", 1.2) offset along directionOn(egoRoute, globalParameters.OPT_GEO_Y) by 0 @ -globalParameters.OPT_BLOCKER_GAP,
    facing directionOn(egoRoute, globalParameters.OPT_GEO_Y),
    with label "parked-car"
new Car at besideRoad(egoRoute, globalParameters.OPT_GEO_Y, "$side", 1.2) offset along directionOn(egoRoute, globalParameters.OPT_GEO_Y) by 0 @ globalParameters.OPT_BLOCKER_GAP,
    facing directionOn(egoRoute, globalParameters.OPT_GEO_Y),
    with label "parked-car"
AdvAgent = new AdvClass at besideRoad(egoRoute, globalParameters.OPT_GEO_Y, "$side", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, globalParameters.OPT_GEO_Y, "$side"),
    with behavior AdvBehavior()
