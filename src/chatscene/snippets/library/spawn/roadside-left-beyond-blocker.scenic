#: description = "A parked car blocks the ego's lane and the adversary stands at the left side of the road beyond it."
#: rephrasings = [
#:   "At the left kerb, just past the stationary vehicle in the ego's way.",
#:   "A jaywalker on the left, farther on than the obstacle the ego goes around.",
#:   "On the left roadside behind the car that obstructs the lane.",
#:   "To the left of the street, beyond the blocked place.",
#:   "Someone waits at the left edge past the obstruction.",
#:   "there's someone on the left once you get round the parked car",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "blockedLane", "egoRoute"]
#: provides = ["AdvAgent"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: side = "left"
#: position = "roadside"
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
#: low = 6.5
#: high = 16.0
#: unit = "m"
#: meaning = "how far beyond the middle of the bypass it starts"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 0.6
#: high = 3.5
#: unit = "m"
#: meaning = "how far outside the lanes it starts"

param OPT_BLOCKER_Y = Range(-3, 3)
param OPT_GEO_Y = Range(6.5, 16)
param OPT_GEO_X = Range(0.6, 3.5)

new Car at pointOn(blockedLane, egoRoute.eventAt + globalParameters.OPT_BLOCKER_Y),
    facing directionOn(blockedLane, egoRoute.eventAt + globalParameters.OPT_BLOCKER_Y),
    with label "blocker"
AdvAgent = new AdvClass at besideRoad(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y, "left", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y, "left"),
    with behavior AdvBehavior()
