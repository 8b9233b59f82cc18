#: description = "A parked car blocks the ego's lane and the adversary comes toward it along the edge of the opposite lane."
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: position = "oncoming"
#: maneuver = "bypass"
#: blocker = true

param OPT_BLOCKER_Y = Range(-3, 3)  #: [m] how far along the middle of the bypass the parked car stands
param OPT_GEO_Y = Range(8, 26)  #: [m] how far beyond the middle of the bypass it starts
param OPT_GEO_X = Range(0, 1.2)  #: [m] how far outside the lanes it starts

new Car at pointOn(blockedLane, egoRoute.eventAt + globalParameters.OPT_BLOCKER_Y),
    facing directionOn(blockedLane, egoRoute.eventAt + globalParameters.OPT_BLOCKER_Y),
    with label "blocker"
AdvAgent = new AdvClass at besideRoad(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y, "left", globalParameters.OPT_GEO_X),
    facing directionOn(blockedLane, egoRoute.eventAt + globalParameters.OPT_GEO_Y, advFacing),
    with behavior AdvBehavior()
