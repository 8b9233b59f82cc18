#: description = "The adversary stands between two parked cars on the left front."
#: rephrasings = [
#:   "In the gap of a row of parked cars along the left kerb.",
#:   "somebody pops out from between the cars parked on the left",
#:   "between parked vehs, left side",
#:   "The non-motorist was located between two legally parked vehicles at the left curb.",
#:   "The target starts in the gap of two stationary passenger cars on the offside side.",
#:   "He is in the middle of two standing autos, on left border of the street.",
#: ]
#: adversaries = ["pedestrian", "bicycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent"]
#: origin = "Euro NCAP CPNCO: a child between parked cars"
#: [slots]
#: side = "left"
#: position = "roadside"
#: occluder = "parked-car"
#: place = "road"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 30.0
#: high = 52.0
#: unit = "m"
#: meaning = "how far along the ego's route it starts"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 1.3
#: high = 2.0
#: unit = "m"
#: meaning = "how far outside the lanes it starts"
#: [[parameters]]
#: name = "OPT_BLOCKER_GAP"
#: low = 3.6
#: high = 4.2
#: unit = "m"
#: meaning = "how far before and behind it the middles of the two cars stand"

param OPT_GEO_Y = Range(30, 52)
param OPT_GEO_X = Range(1.3, 2)
param OPT_BLOCKER_GAP = Range(3.6, 4.2)

new Car at besideRoad(egoRoute, globalParameters.OPT_GEO_Y, "left", 1.2) offset along directionOn(egoRoute, globalParameters.OPT_GEO_Y) by 0 @ -globalParameters.OPT_BLOCKER_GAP,
    facing directionOn(egoRoute, globalParameters.OPT_GEO_Y),
    with label "parked-car"
new Car at besideRoad(egoRoute, globalParameters.OPT_GEO_Y, "left", 1.2) offset along directionOn(egoRoute, globalParameters.OPT_GEO_Y) by 0 @ globalParameters.OPT_BLOCKER_GAP,
    facing directionOn(egoRoute, globalParameters.OPT_GEO_Y),
    with label "parked-car"
AdvAgent = new AdvClass at besideRoad(egoRoute, globalParameters.OPT_GEO_Y, "left", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, globalParameters.OPT_GEO_Y, "left"),
    with behavior AdvBehavior()
