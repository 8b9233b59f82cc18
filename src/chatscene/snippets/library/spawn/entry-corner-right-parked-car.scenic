#: description = "The adversary is hidden by a parked car at the right corner where the ego enters the intersection."
#: rephrasings = [
#:   "At the near right corner of the crossing, behind a standing car.",
#:   "somebody is lurking behind a standing car just before the junction on the right",
#:   "right near corner, occluded by parked car",
#:   "A standing car at the right corner of the approach leg obscured the non-motorist.",
#:   "The target at the nearside corner of the arm from which the VUT comes is obstructed by a standing car.",
#:   "He stays in the right corner before the crossing and a standing car covers him.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent"]
#: origin = "own code"
#: [slots]
#: side = "right"
#: position = "roadside"
#: place = "junction"
#: occluder = "parked-car"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = -7.0
#: high = -0.5
#: unit = "m"
#: meaning = "how far beyond the start of the intersection it starts, along the ego's route"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 1.0
#: high = 2.3
#: unit = "m"
#: meaning = "how far outside the lanes it starts"
#: [[parameters]]
#: name = "OPT_BLOCKER_GAP"
#: low = 3.4
#: high = 5.1
#: unit = "m"
#: meaning = "how far before it, along the road, the middle of what hides it stands"

param OPT_GEO_Y = Range(-7, -0.5)
param OPT_GEO_X = Range(1, 2.3)
param OPT_BLOCKER_GAP = Range(3.4, 5.1)

new Car at besideRoad(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y, "right", 1.2) offset along directionOn(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y) by 0 @ -globalParameters.OPT_BLOCKER_GAP,
    facing directionOn(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y),
    with label "parked-car"
AdvAgent = new AdvClass at besideRoad(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y, "right", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y, "right"),
    with behavior AdvBehavior()
