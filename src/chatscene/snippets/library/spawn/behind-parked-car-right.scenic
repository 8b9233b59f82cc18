#: description = "The adversary is behind a parked car on the right front."
#: rephrasings = [
#:   "A car standing at the right kerb conceals it.",
#:   "Hidden in front of a stationary automobile, right side of the road.",
#:   "It is out of sight beyond a vehicle left at the right edge.",
#:   "Between parked cars on the right.",
#:   "The ego cannot see it past the car that is parked ahead on the right.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: side = "right"
#: position = "roadside"
#: occluder = "parked-car"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 22.0
#: high = 50.0
#: unit = "m"
#: meaning = "how far along the ego's route it starts"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 0.6
#: high = 2.5
#: unit = "m"
#: meaning = "how far outside the lanes it starts"
#: [[parameters]]
#: name = "OPT_BLOCKER_GAP"
#: low = 3.4
#: high = 5.1
#: unit = "m"
#: meaning = "how far before it, along the road, the middle of what hides it stands"

param OPT_GEO_Y = Range(22, 50)
param OPT_GEO_X = Range(0.6, 2.5)
param OPT_BLOCKER_GAP = Range(3.4, 5.1)

new Car at besideRoad(egoRoute, globalParameters.OPT_GEO_Y - globalParameters.OPT_BLOCKER_GAP, "right", 1.2),
    facing directionOn(egoRoute, globalParameters.OPT_GEO_Y - globalParameters.OPT_BLOCKER_GAP),
    with label "parked-car"
AdvAgent = new AdvClass at besideRoad(egoRoute, globalParameters.OPT_GEO_Y, "right", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, globalParameters.OPT_GEO_Y, "right"),
    with behavior AdvBehavior()
