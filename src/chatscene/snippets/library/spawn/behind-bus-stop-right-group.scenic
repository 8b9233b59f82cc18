#: description = "People wait at a bus stop on the right front; the adversary is among them, hidden by the shelter."
#: rephrasings = [
#:   "A crowd of passengers behind the shelter on the right.",
#:   "lots of people waiting for the bus on our right, half of them behind the shelter",
#:   "group of peds occluded by bus shelter, right",
#:   "Multiple pedestrians were waiting behind a transit shelter along the right curb.",
#:   "The target and two companions are obstructed by a bus stop on the nearside.",
#:   "Many persons stay after the station of the bus on right hand, they wait together.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advLevel"]
#: origin = "own code"
#: [slots]
#: side = "right"
#: position = "roadside"
#: occluder = "bus-stop"
#: group = true
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
#: high = 4.0
#: unit = "m"
#: meaning = "how far before it, along the road, the middle of what hides it stands"

param OPT_GEO_Y = Range(22, 50)
param OPT_GEO_X = Range(1.5, 2.3)
param OPT_BLOCKER_GAP = Range(2.7, 4)

# Not in the middle of an intersection, where the side of the road would be far away.
advLevel = shortOfJunction(egoRoute, globalParameters.OPT_GEO_Y)
new BusStop at besideRoad(egoRoute, advLevel - globalParameters.OPT_BLOCKER_GAP, "right", 1.6),
    facing directionOn(egoRoute, advLevel - globalParameters.OPT_BLOCKER_GAP),
    with label "bus-stop"
AdvAgent = new AdvClass at besideRoad(egoRoute, advLevel, "right", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, advLevel, "right"),
    with behavior AdvBehavior()
new AdvClass at besideRoad(egoRoute, advLevel + 1.2, "right", globalParameters.OPT_GEO_X + 0.6),
    facing crossingDirection(egoRoute, advLevel + 1.2, "right"),
    with behavior AdvBehavior()
new AdvClass at besideRoad(egoRoute, advLevel + 2.4, "right", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, advLevel + 2.4, "right"),
    with behavior AdvBehavior()
