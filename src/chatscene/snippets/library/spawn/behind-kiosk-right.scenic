#: description = "The adversary is behind a kiosk on the right front."
#: rephrasings = [
#:   "A newsstand at the right pavement conceals it.",
#:   "Hidden by a small stall, right of the street.",
#:   "Out of sight in back of a food stand on the right.",
#:   "The ego's view of it is blocked by a booth ahead, right.",
#:   "It waits around the corner of a kiosk at the right kerb.",
#:   "The non-motorist was obscured by a newsstand along the right curb.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advLevel"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: side = "right"
#: position = "roadside"
#: occluder = "kiosk"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 22.0
#: high = 50.0
#: unit = "m"
#: meaning = "how far along the ego's route it starts"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 1.6
#: high = 2.7
#: unit = "m"
#: meaning = "how far outside the lanes it starts"
#: [[parameters]]
#: name = "OPT_BLOCKER_GAP"
#: low = 2.1
#: high = 3.8
#: unit = "m"
#: meaning = "how far before it, along the road, the middle of what hides it stands"

param OPT_GEO_Y = Range(22, 50)
param OPT_GEO_X = Range(1.6, 2.7)
param OPT_BLOCKER_GAP = Range(2.1, 3.8)

# Not in the middle of an intersection, where the side of the road would be far away.
advLevel = shortOfJunction(egoRoute, globalParameters.OPT_GEO_Y)
new Kiosk at besideRoad(egoRoute, advLevel - globalParameters.OPT_BLOCKER_GAP, "right", 1.8),
    facing directionOn(egoRoute, advLevel - globalParameters.OPT_BLOCKER_GAP),
    with label "kiosk"
AdvAgent = new AdvClass at besideRoad(egoRoute, advLevel, "right", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, advLevel, "right"),
    with behavior AdvBehavior()
