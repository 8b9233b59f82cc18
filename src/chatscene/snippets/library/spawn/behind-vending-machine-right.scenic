#: description = "The adversary is hidden behind a vending machine on the right front."
#: rephrasings = [
#:   "A drinks machine at the right kerb conceals it.",
#:   "Out of sight in back of a vending machine, right of the road.",
#:   "The ego's view of it is blocked by an automat on the right.",
#:   "It lurks beyond a ticket or snack machine at the right-hand pavement.",
#:   "Behind a dispenser ahead on the right.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent"]
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
#: low = 1.2
#: high = 2.1
#: unit = "m"
#: meaning = "how far outside the lanes it starts"
#: [[parameters]]
#: name = "OPT_BLOCKER_GAP"
#: low = 1.5
#: high = 3.2
#: unit = "m"
#: meaning = "how far before it, along the road, the middle of what hides it stands"

param OPT_GEO_Y = Range(22, 50)
param OPT_GEO_X = Range(1.2, 2.1)
param OPT_BLOCKER_GAP = Range(1.5, 3.2)

new VendingMachine at besideRoad(egoRoute, globalParameters.OPT_GEO_Y - globalParameters.OPT_BLOCKER_GAP, "right", 1.4),
    facing directionOn(egoRoute, globalParameters.OPT_GEO_Y - globalParameters.OPT_BLOCKER_GAP),
    with label "vending-machine"
AdvAgent = new AdvClass at besideRoad(egoRoute, globalParameters.OPT_GEO_Y, "right", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, globalParameters.OPT_GEO_Y, "right"),
    with behavior AdvBehavior()
