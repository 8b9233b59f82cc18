#: description = "The adversary stands at the right kerb behind another parked car."
#: rephrasings = [
#:   "In a row of parked cars on the right, with one in front of it as the ego sees it.",
#:   "it's parked on the right with another car parked behind it, so you hardly see it",
#:   "parked veh row, right kerb, second in line",
#:   "Vehicle 2 was parked along the right curb, obscured by another parked vehicle.",
#:   "The target is at rest on the nearside, obstructed by a further stationary car.",
#:   "It stays in the line of standing autos on right hand, after the first one.",
#: ]
#: adversaries = ["car", "truck", "motorcycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "egoRoute", "kerbLane"]
#: provides = ["AdvAgent", "advKerb"]
#: origin = "own code"
#: [slots]
#: side = "right"
#: position = "kerb"
#: occluder = "parked-car"
#: place = "road"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 20.0
#: high = 34.0
#: unit = "m"
#: meaning = "how far ahead of the ego it stands"

param OPT_GEO_Y = Range(20, 34)

advKerb = kerbLane.offset(kerbLane.project(*besideRoad(egoRoute, 20, "right", 1.3).coordinates[:2])[1])
AdvAgent = new AdvClass at pointOn(advKerb, globalParameters.OPT_GEO_Y),
    facing directionOn(advKerb, globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
new Car at pointOn(advKerb, globalParameters.OPT_GEO_Y - 8.2),
    facing directionOn(advKerb, globalParameters.OPT_GEO_Y - 8.2),
    with label "parked-car"
