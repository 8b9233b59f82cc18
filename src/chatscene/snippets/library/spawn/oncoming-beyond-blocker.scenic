#: description = "A parked car blocks the ego's lane and the adversary comes toward it in the opposite lane."
#: rephrasings = [
#:   "Beyond a stationary vehicle in the ego's lane, facing the ego on the other side of the road.",
#:   "Oncoming in the lane the ego has to borrow, past the obstacle.",
#:   "A car stands in the way; from ahead, the other one approaches on the opposing lane.",
#:   "The motorcyclist comes the opposite way behind the obstruction.",
#:   "In the counter lane, farther on than the car that obstructs the ego.",
#:   "opposing veh past the obstacle in ego lane",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "blockedLane", "egoRoute", "oppositeLane"]
#: provides = ["AdvAgent", "advTrajectory"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: position = "oncoming"
#: blocker = true
#: maneuver = "bypass"
#: [[parameters]]
#: name = "OPT_BLOCKER_Y"
#: low = -3.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far along the middle of the bypass the parked car stands"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 14.0
#: high = 70.0
#: unit = "m"
#: meaning = "how far beyond the middle of the bypass it starts"

param OPT_BLOCKER_Y = Range(-3, 3)
param OPT_GEO_Y = Range(14, 70)

new Car at pointOn(blockedLane, egoRoute.eventAt + globalParameters.OPT_BLOCKER_Y),
    facing directionOn(blockedLane, egoRoute.eventAt + globalParameters.OPT_BLOCKER_Y),
    with label "blocker"
advTrajectory = oppositeLane
AdvAgent = new AdvClass at pointOn(advTrajectory, levelOn(advTrajectory, egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y)),
    facing directionOn(advTrajectory, levelOn(advTrajectory, egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y)),
    with behavior AdvBehavior()
