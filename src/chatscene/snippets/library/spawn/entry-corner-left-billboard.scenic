#: description = "The adversary is hidden by a billboard at the left corner where the ego enters the intersection."
#: rephrasings = [
#:   "At the near left corner of the crossing, behind an advertising pillar.",
#:   "somebody is lurking behind an advertising pillar just before the junction on the left",
#:   "left near corner, occluded by billboard",
#:   "An advertising pillar at the left corner of the approach leg obscured the non-motorist.",
#:   "The target at the offside corner of the arm from which the VUT comes is obstructed by an advertising pillar.",
#:   "He stays in the left corner before the crossing and an advertising pillar covers him.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent"]
#: origin = "own code"
#: [slots]
#: side = "left"
#: position = "roadside"
#: place = "junction"
#: occluder = "billboard"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = -7.0
#: high = -0.5
#: unit = "m"
#: meaning = "how far beyond the start of the intersection it starts, along the ego's route"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 2.2
#: high = 2.8
#: unit = "m"
#: meaning = "how far outside the lanes it starts"
#: [[parameters]]
#: name = "OPT_BLOCKER_GAP"
#: low = 2.0
#: high = 2.7
#: unit = "m"
#: meaning = "how far before it, along the road, the middle of what hides it stands"

param OPT_GEO_Y = Range(-7, -0.5)
param OPT_GEO_X = Range(2.2, 2.8)
param OPT_BLOCKER_GAP = Range(2, 2.7)

new Billboard at besideRoad(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y, "left", 1.5) offset along directionOn(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y) by 0 @ -globalParameters.OPT_BLOCKER_GAP,
    facing directionOn(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y),
    with label "billboard"
AdvAgent = new AdvClass at besideRoad(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y, "left", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y, "left"),
    with behavior AdvBehavior()
