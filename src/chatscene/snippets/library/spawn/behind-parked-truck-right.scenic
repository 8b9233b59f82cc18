#: description = "The adversary is behind a parked truck on the right front."
#: rephrasings = [
#:   "A lorry standing at the right kerb conceals it.",
#:   "Hidden by a delivery van or truck, right side of the road.",
#:   "Out of sight in front of a big stationary lorry on the right.",
#:   "The ego's view is blocked by a truck parked ahead, right.",
#:   "It is about to emerge from beyond a halted lorry at the right edge.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: side = "right"
#: position = "roadside"
#: occluder = "parked-truck"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 22.0
#: high = 50.0
#: unit = "m"
#: meaning = "how far along the ego's route it starts"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 0.6
#: high = 2.6
#: unit = "m"
#: meaning = "how far outside the lanes it starts"
#: [[parameters]]
#: name = "OPT_BLOCKER_GAP"
#: low = 4.8
#: high = 6.5
#: unit = "m"
#: meaning = "how far before it, along the road, the middle of what hides it stands"

param OPT_GEO_Y = Range(22, 50)
param OPT_GEO_X = Range(0.6, 2.6)
param OPT_BLOCKER_GAP = Range(4.8, 6.5)

new Truck at besideRoad(egoRoute, globalParameters.OPT_GEO_Y - globalParameters.OPT_BLOCKER_GAP, "right", 1.35),
    facing directionOn(egoRoute, globalParameters.OPT_GEO_Y - globalParameters.OPT_BLOCKER_GAP),
    with label "parked-truck"
AdvAgent = new AdvClass at besideRoad(egoRoute, globalParameters.OPT_GEO_Y, "right", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, globalParameters.OPT_GEO_Y, "right"),
    with behavior AdvBehavior()
