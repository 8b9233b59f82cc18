#: description = "The adversary is hidden by a hedge at the right corner where the ego enters the intersection."
#: rephrasings = [
#:   "At the near right corner of the crossing, behind bushes.",
#:   "somebody is lurking behind bushes just before the junction on the right",
#:   "right near corner, occluded by hedge",
#:   "Bushes at the right corner of the approach leg obscured the non-motorist.",
#:   "The target at the nearside corner of the arm from which the VUT comes is obstructed by bushes.",
#:   "He stays in the right corner before the crossing and bushes covers him.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent"]
#: origin = "own code"
#: [slots]
#: side = "right"
#: position = "roadside"
#: place = "junction"
#: occluder = "hedge"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = -7.0
#: high = -0.5
#: unit = "m"
#: meaning = "how far beyond the start of the intersection it starts, along the ego's route"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 1.4
#: high = 2.2
#: unit = "m"
#: meaning = "how far outside the lanes it starts"
#: [[parameters]]
#: name = "OPT_BLOCKER_GAP"
#: low = 3.1
#: high = 3.9
#: unit = "m"
#: meaning = "how far before it, along the road, the middle of what hides it stands"

param OPT_GEO_Y = Range(-7, -0.5)
param OPT_GEO_X = Range(1.4, 2.2)
param OPT_BLOCKER_GAP = Range(3.1, 3.9)

new Hedge at besideRoad(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y, "right", 1.2) offset along directionOn(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y) by 0 @ -globalParameters.OPT_BLOCKER_GAP,
    facing directionOn(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y),
    with label "hedge"
AdvAgent = new AdvClass at besideRoad(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y, "right", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y, "right"),
    with behavior AdvBehavior()
