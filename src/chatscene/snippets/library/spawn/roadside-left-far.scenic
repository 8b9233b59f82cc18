#: description = "The adversary stands at the left side of the road, far ahead of the ego."
#: rephrasings = [
#:   "A good way down the road on the left, beside the carriageway.",
#:   "way up ahead there's somebody standing on the left",
#:   "ped at left road edge, far ahead, > 35 m",
#:   "The non-motorist was standing off the left edge of the road a considerable distance ahead of Vehicle 1.",
#:   "The target is initially positioned on the offside pavement, well beyond the stopping distance of the VUT.",
#:   "He waits far in the front on left border of the street.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["AdvBehavior", "egoRoute"]
#: provides = ["AdvAgent"]
#: origin = "own code"
#: [slots]
#: side = "left"
#: position = "roadside"
#: distance = "far"
#: place = "road"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 42.0
#: high = 62.0
#: unit = "m"
#: meaning = "how far along the ego's route it starts"
#: [[parameters]]
#: name = "OPT_GEO_X"
#: low = 0.6
#: high = 3.0
#: unit = "m"
#: meaning = "how far outside the lanes it starts"

param OPT_GEO_Y = Range(42, 62)
param OPT_GEO_X = Range(0.6, 3)

AdvAgent = new AdvClass at besideRoad(egoRoute, globalParameters.OPT_GEO_Y, "left", globalParameters.OPT_GEO_X),
    facing crossingDirection(egoRoute, globalParameters.OPT_GEO_Y, "left"),
    with behavior AdvBehavior()
