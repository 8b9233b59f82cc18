#: description = "The adversary is behind a parked car on the left front."
#: rephrasings = [
#:   "A car standing at the left kerb conceals it.",
#:   "Hidden in front of a stationary automobile, left side of the road.",
#:   "It is out of sight beyond a vehicle left at the left edge.",
#:   "Between parked cars on the left.",
#:   "The ego cannot see it past the car that is parked ahead on the left.",
#:   "ped occluded by parked car, left side",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advLevel"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: side = "left"
#: position = "roadside"
#: occluder = "parked-car"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 30.0
#: high = 52.0
#: unit = "m"
#: meaning = "how far along the ego's route it starts"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 1.3
#: high = 2.5
#: unit = "m"
#: meaning = "how far outside the lanes it starts"
#: [[parameters]]
#: name = "OPT_BLOCKER_GAP"
#: low = 3.4
#: high = 5.1
#: unit = "m"
#: meaning = "how far before it, along the road, the middle of what hides it stands"

param OPT_GEO_Y = Range(30, 52)
param OPT_GEO_X = Range(1.3, 2.5)
param OPT_BLOCKER_GAP = Range(3.4, 5.1)

# Not in the middle of an intersection, where the side of the road would be far away.
advLevel = shortOfJunction(egoRoute, globalParameters.OPT_GEO_Y)
new Car at besideRoad(egoRoute, advLevel - globalParameters.OPT_BLOCKER_GAP, "left", 1.2),
    facing directionOn(egoRoute, advLevel - globalParameters.OPT_BLOCKER_GAP),
    with label "parked-car"
AdvAgent = new AdvClass at besideRoad(egoRoute, advLevel, "left", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, advLevel, "left"),
    with behavior AdvBehavior()
