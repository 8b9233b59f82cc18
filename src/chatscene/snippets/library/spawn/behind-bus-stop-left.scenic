#: description = "The adversary is behind a bus stop on the left front."
#: rephrasings = [
#:   "Hidden by a bus shelter at the left side of the road.",
#:   "A bus stop on the left conceals it from the ego.",
#:   "It stands at the far end of a shelter, left of the carriageway.",
#:   "Someone waits out of sight in back of the bus stop, left front.",
#:   "The shelter for passengers on the left blocks the view of it.",
#:   "somebody's hanging about behind the bus shelter on our left",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advLevel"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: side = "left"
#: position = "roadside"
#: occluder = "bus-stop"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 30.0
#: high = 52.0
#: unit = "m"
#: meaning = "how far along the ego's route it starts"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 1.9
#: high = 2.5
#: unit = "m"
#: meaning = "how far outside the lanes it starts"
#: [[parameters]]
#: name = "OPT_BLOCKER_GAP"
#: low = 2.7
#: high = 4.4
#: unit = "m"
#: meaning = "how far before it, along the road, the middle of what hides it stands"

param OPT_GEO_Y = Range(30, 52)
param OPT_GEO_X = Range(1.9, 2.5)
param OPT_BLOCKER_GAP = Range(2.7, 4.4)

# Not in the middle of an intersection, where the side of the road would be far away.
advLevel = shortOfJunction(egoRoute, globalParameters.OPT_GEO_Y)
new BusStop at besideRoad(egoRoute, advLevel - globalParameters.OPT_BLOCKER_GAP, "left", 1.6),
    facing directionOn(egoRoute, advLevel - globalParameters.OPT_BLOCKER_GAP),
    with label "bus-stop"
AdvAgent = new AdvClass at besideRoad(egoRoute, advLevel, "left", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, advLevel, "left"),
    with behavior AdvBehavior()
