#: description = "A parked car blocks the ego's lane and the adversary comes toward it in the opposite lane."
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: position = "oncoming"
#: maneuver = "bypass"
#: blocker = true

param OPT_BLOCKER_Y = Range(-3, 3)  #: [m] how far along the middle of the bypass the parked car stands
param OPT_GEO_Y = Range(14, 70)  #: [m] how far beyond the middle of the bypass it starts

new Car at pointOn(blockedLane, egoRoute.eventAt + globalParameters.OPT_BLOCKER_Y),
    facing directionOn(blockedLane, egoRoute.eventAt + globalParameters.OPT_BLOCKER_Y),
    with label "blocker"
advTrajectory = oppositeLane
AdvAgent = new AdvClass at pointOn(advTrajectory, levelOn(advTrajectory, egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y)),
    facing directionOn(advTrajectory, levelOn(advTrajectory, egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y)),
    with behavior AdvBehavior()
