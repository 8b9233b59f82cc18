#: description = "The adversary stands parked at the left kerb, across the oncoming lane, facing the way the ego drives."
#: rephrasings = [
#:   "Somebody has parked on the wrong side of the street, nose pointing the same way as us.",
#:   "Stationary at the left-hand edge of the carriageway, in front of the ego.",
#:   "parked veh, left kerb, other side of the two-way street",
#:   "Vehicle 2 was standing at the opposite curb, headed in the same direction as Vehicle 1.",
#:   "It waits at the left border of the road, beyond the lane for those who come the other way.",
#:   "The target is at rest on the far side of the carriageway, offside verge.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "egoRoute", "kerbLane", "oppositeLane"]
#: provides = ["AdvAgent", "advKerb"]
#: origin = "own code"
#: [slots]
#: side = "left"
#: position = "kerb"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 16.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far ahead of the ego it stands"

param OPT_GEO_Y = Range(16, 30)

advKerb = kerbLane.offset(kerbLane.project(*pointOn(oppositeLane, levelOn(oppositeLane, egoRoute, 20), -2.1).coordinates[:2])[1])
AdvAgent = new AdvClass at pointOn(advKerb, globalParameters.OPT_GEO_Y),
    facing directionOn(advKerb, globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
