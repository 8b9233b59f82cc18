#: description = "The adversary is behind a parked bus on the right front."
#: rephrasings = [
#:   "A stationary bus at the right kerb hides it.",
#:   "somebody is right in front of a coach that's pulled up on the right",
#:   "emerging from in front of stopped bus, right",
#:   "A bus stopped along the right curb obstructed the driver's view of the non-motorist.",
#:   "The target is obstructed by a bus at rest on the nearside side of the carriageway.",
#:   "He comes from before the bus which stands on right hand, one can not see him.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advLevel"]
#: origin = "own code"
#: [slots]
#: side = "right"
#: position = "roadside"
#: occluder = "parked-bus"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 22.0
#: high = 50.0
#: unit = "m"
#: meaning = "how far along the ego's route it starts"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 1.0
#: high = 2.5
#: unit = "m"
#: meaning = "how far outside the lanes it starts"
#: [[parameters]]
#: name = "OPT_BLOCKER_GAP"
#: low = 7.1
#: high = 8.2
#: unit = "m"
#: meaning = "how far before it, along the road, the middle of what hides it stands"

param OPT_GEO_Y = Range(22, 50)
param OPT_GEO_X = Range(1, 2.5)
param OPT_BLOCKER_GAP = Range(7.1, 8.2)

# Not in the middle of an intersection, where the side of the road would be far away.
advLevel = shortOfJunction(egoRoute, globalParameters.OPT_GEO_Y)
new Bus at besideRoad(egoRoute, advLevel, "right", 1.35) offset along directionOn(egoRoute, advLevel) by 0 @ -globalParameters.OPT_BLOCKER_GAP,
    facing directionOn(egoRoute, advLevel),
    with label "parked-bus"
AdvAgent = new AdvClass at besideRoad(egoRoute, advLevel, "right", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, advLevel, "right"),
    with behavior AdvBehavior()
