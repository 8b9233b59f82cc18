#: description = "The adversary is behind a bus stop on the right front."
#: rephrasings = [
#:   "Hidden by a bus shelter at the right side of the road.",
#:   "A bus stop on the right conceals it from the ego.",
#:   "It stands at the far end of a shelter, right of the carriageway.",
#:   "Someone waits out of sight in back of the bus stop, right front.",
#:   "The shelter for passengers on the right blocks the view of it.",
#:   "ped occluded by bus shelter, right side",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advLevel"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: side = "right"
#: position = "roadside"
#: occluder = "bus-stop"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 22.0
#: high = 50.0
#: unit = "m"
#: meaning = "how far along the ego's route it starts"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 1.5
#: high = 2.3
#: unit = "m"
#: meaning = "how far outside the lanes it starts"
#: [[parameters]]
#: name = "OPT_BLOCKER_GAP"
#: low = 2.7
#: high = 4.4
#: unit = "m"
#: meaning = "how far before it, along the road, the middle of what hides it stands"

param OPT_GEO_Y = Range(22, 50)
param OPT_GEO_X = Range(1.5, 2.3)
param OPT_BLOCKER_GAP = Range(2.7, 4.4)

# Not in the middle of an intersection, where the side of the road would be far away.
advLevel = shortOfJunction(egoRoute, globalParameters.OPT_GEO_Y)
new BusStop at besideRoad(egoRoute, advLevel - globalParameters.OPT_BLOCKER_GAP, "right", 1.6),
    facing directionOn(egoRoute, advLevel - globalParameters.OPT_BLOCKER_GAP),
    with label "bus-stop"
AdvAgent = new AdvClass at besideRoad(egoRoute, advLevel, "right", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, advLevel, "right"),
    with behavior AdvBehavior()
