#: description = "The adversary is hidden behind a vending machine on the right front."
#: rephrasings = [
#:   "A drinks machine at the right kerb conceals it.",
#:   "Out of sight in back of a vending machine, right of the road.",
#:   "The ego's view of it is blocked by an automat on the right.",
#:   "It lurks beyond a ticket or snack machine at the right-hand pavement.",
#:   "Behind a dispenser ahead on the right.",
#:   "ped occluded by vending machine, right side",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent", "advLevel"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: side = "right"
#: position = "roadside"
#: occluder = "vending-machine"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 22.0
#: high = 50.0
#: unit = "m"
#: meaning = "how far along the ego's route it starts"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 1.5
#: high = 2.2
#: unit = "m"
#: meaning = "how far outside the lanes it starts"
#: [[parameters]]
#: name = "OPT_BLOCKER_GAP"
#: low = 1.5
#: high = 2.3
#: unit = "m"
#: meaning = "how far before it, on the line of sight from the ego, the middle of what hides it stands"

param OPT_GEO_Y = Range(22, 50)
param OPT_GEO_X = Range(1.5, 2.2)
param OPT_BLOCKER_GAP = Range(1.5, 2.3)

# Not in the middle of an intersection, where the side of the road would be far away.
advLevel = shortOfJunction(egoRoute, globalParameters.OPT_GEO_Y)
# On the line of sight of an ego that is some way off, in bends too.
new VendingMachine at besideRoad(egoRoute, advLevel, "right", globalParameters.OPT_GEO_X) offset along (angle from besideRoad(egoRoute, advLevel, "right", globalParameters.OPT_GEO_X) to pointOn(egoRoute, advLevel - 25)) by 0 @ globalParameters.OPT_BLOCKER_GAP,
    facing directionOn(egoRoute, advLevel),
    with label "vending-machine"
AdvAgent = new AdvClass at besideRoad(egoRoute, advLevel, "right", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, advLevel, "right"),
    with behavior AdvBehavior()
