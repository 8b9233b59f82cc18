#: description = "The adversary is behind a parked truck on the left front."
#: rephrasings = [
#:   "A lorry parked at the left kerb keeps it out of sight.",
#:   "you can't see him, there's a big delivery van standing on the left",
#:   "occluded by parked HGV, left side",
#:   "Vehicle 3, a truck legally parked on the left, blocked the view of the non-motorist.",
#:   "The target is obstructed by a stationary goods vehicle on the offside side.",
#:   "He is after the standing camion on left side of the street.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advLevel"]
#: origin = "own code"
#: [slots]
#: side = "left"
#: position = "roadside"
#: occluder = "parked-truck"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 30.0
#: high = 52.0
#: unit = "m"
#: meaning = "how far along the ego's route it starts"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 1.7
#: high = 2.8
#: unit = "m"
#: meaning = "how far outside the lanes it starts"
#: [[parameters]]
#: name = "OPT_BLOCKER_GAP"
#: low = 5.2
#: high = 6.4
#: unit = "m"
#: meaning = "how far before it, along the road, the middle of what hides it stands"

param OPT_GEO_Y = Range(30, 52)
param OPT_GEO_X = Range(1.7, 2.8)
param OPT_BLOCKER_GAP = Range(5.2, 6.4)

# Not in the middle of an intersection, where the side of the road would be far away.
advLevel = shortOfJunction(egoRoute, globalParameters.OPT_GEO_Y)
new Truck at besideRoad(egoRoute, advLevel, "left", 1.35) offset along directionOn(egoRoute, advLevel) by 0 @ -globalParameters.OPT_BLOCKER_GAP,
    facing directionOn(egoRoute, advLevel),
    with label "parked-truck"
AdvAgent = new AdvClass at besideRoad(egoRoute, advLevel, "left", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, advLevel, "left"),
    with behavior AdvBehavior()
