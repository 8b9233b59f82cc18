#: description = "A parked car blocks the ego's lane and the adversary comes toward it along the edge of the opposite lane."
#: rephrasings = [
#:   "Beyond a stationary vehicle, a person walks toward the ego at the far road edge.",
#:   "An oncoming pedestrian past the obstacle, on the other side of the carriageway.",
#:   "Someone on foot approaches from ahead beside the opposing lane; a car obstructs the ego.",
#:   "Facing the ego, at the left border of the street, farther on than the blocking car.",
#:   "The walker comes the other way, behind the obstruction.",
#:   "ped walking toward ego past the obstacle",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "advFacing", "blockedLane", "egoRoute"]
#: provides = ["AdvAgent"]
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
#: low = 8.0
#: high = 26.0
#: unit = "m"
#: meaning = "how far beyond the middle of the bypass it starts"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 0.0
#: high = 1.2
#: unit = "m"
#: meaning = "how far outside the lanes it starts"

param OPT_BLOCKER_Y = Range(-3, 3)
param OPT_GEO_Y = Range(8, 26)
param OPT_GEO_X = Range(0, 1.2)

new Car at pointOn(blockedLane, egoRoute.eventAt + globalParameters.OPT_BLOCKER_Y),
    facing directionOn(blockedLane, egoRoute.eventAt + globalParameters.OPT_BLOCKER_Y),
    with label "blocker"
AdvAgent = new AdvClass at besideRoad(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y, "left", globalParameters.OPT_GEO_X),
    facing directionOn(blockedLane, egoRoute.eventAt + globalParameters.OPT_GEO_Y, advFacing),
    with behavior AdvBehavior()
