#: description = "A stopped bus blocks the ego's lane and the adversary stands at the left side of the road in front of the bus."
#: rephrasings = [
#:   "On the left, just ahead of a bus that halts in the lane of the ego.",
#:   "the bus has stopped in our lane and somebody's on the left right in front of it",
#:   "stopped bus in lane, ped left beyond it",
#:   "The non-motorist was on the left in front of a bus stopped in lane 1.",
#:   "The target starts left of the carriageway beyond a stationary bus which the VUT passes.",
#:   "Before the standing bus, on left hand, waits the person.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "blockedLane", "egoRoute"]
#: provides = ["AdvAgent"]
#: origin = "passing a stopped bus: pedestrians run out in front of it"
#: [slots]
#: side = "left"
#: position = "roadside"
#: blocker = true
#: maneuver = "bypass"
#: [[parameters]]
#: name = "OPT_BLOCKER_Y"
#: low = -2.0
#: high = 2.0
#: unit = "m"
#: meaning = "how far along the middle of the bypass the bus stands"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 9.5
#: high = 17.0
#: unit = "m"
#: meaning = "how far beyond the middle of the bypass it starts"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 0.4
#: high = 2.5
#: unit = "m"
#: meaning = "how far outside the lanes it starts"

param OPT_BLOCKER_Y = Range(-2, 2)
param OPT_GEO_Y = Range(9.5, 17)
param OPT_GEO_X = Range(0.4, 2.5)

new Bus at pointOn(blockedLane, egoRoute.eventAt + globalParameters.OPT_BLOCKER_Y),
    facing directionOn(blockedLane, egoRoute.eventAt + globalParameters.OPT_BLOCKER_Y),
    with label "blocker"
AdvAgent = new AdvClass at besideRoad(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y, "left", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, egoRoute.eventAt + globalParameters.OPT_GEO_Y, "left"),
    with behavior AdvBehavior()
