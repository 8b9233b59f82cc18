#: description = "The adversary is behind a kiosk on the left front."
#: rephrasings = [
#:   "Out of view at the back of a newspaper stand, left of the road.",
#:   "somebody steps round from the little shop hut on the left",
#:   "occluded by kiosk, left side",
#:   "The non-motorist's approach was obscured by a vendor's booth adjacent to the left edge of the roadway.",
#:   "The target is obstructed by a sales booth on the offside pavement.",
#:   "He is behind the small house where they sell newspapers, on left hand.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advLevel"]
#: origin = "own code"
#: [slots]
#: side = "left"
#: position = "roadside"
#: occluder = "kiosk"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 30.0
#: high = 52.0
#: unit = "m"
#: meaning = "how far along the ego's route it starts"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 1.9
#: high = 2.8
#: unit = "m"
#: meaning = "how far outside the lanes it starts"
#: [[parameters]]
#: name = "OPT_BLOCKER_GAP"
#: low = 2.0
#: high = 2.9
#: unit = "m"
#: meaning = "how far before it, along the road, the middle of what hides it stands"

param OPT_GEO_Y = Range(30, 52)
param OPT_GEO_X = Range(1.9, 2.8)
param OPT_BLOCKER_GAP = Range(2, 2.9)

# Not in the middle of an intersection, where the side of the road would be far away.
advLevel = shortOfJunction(egoRoute, globalParameters.OPT_GEO_Y)
new Kiosk at besideRoad(egoRoute, advLevel, "left", 1.7) offset along directionOn(egoRoute, advLevel) by 0 @ -globalParameters.OPT_BLOCKER_GAP,
    facing directionOn(egoRoute, advLevel),
    with label "kiosk"
AdvAgent = new AdvClass at besideRoad(egoRoute, advLevel, "left", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, advLevel, "left"),
    with behavior AdvBehavior()
